#pragma once

#include <CLI/App.hpp>

#include "host/base/log.h"
#include "host/base/work.h"

/// The commands of offing-mesh.
namespace offing::mesh_tools {

/// What every command understands.
struct Options {
  Verbosity verbosity = Verbosity::normal;
  const CancelToken& cancel;  ///< set by Ctrl-C
};

/// Makes the command line of offing-mesh: its help and all of its commands. `options` must outlive it.
void add_commands(CLI::App& app, Options& options);

/// `offing-mesh check IN`: what is to know about a mesh before it is used.
void add_check_command(CLI::App& program, Options& options);

/// `offing-mesh curvature IN -o OUT.ply`: how a mesh bends at its vertices.
void add_curvature_command(CLI::App& program, Options& options);

/// `offing-mesh generate SHAPE -o OUT.ply`: meshes made by formulas.
void add_generate_command(CLI::App& program, Options& options);

/// `offing-mesh repair IN -o OUT`: an oriented manifold of any triangles, and what had to be changed.
void add_repair_command(CLI::App& program, Options& options);

/// `offing-mesh remesh IN -o OUT`: the same surface with edges of about one length.
void add_remesh_command(CLI::App& program, Options& options);

/// `offing-mesh simplify IN -o OUT`: fewer faces of the same shape.
void add_simplify_command(CLI::App& program, Options& options);

/// `offing-mesh subdivide IN -o OUT`: a finer, smoother mesh.
void add_subdivide_command(CLI::App& program, Options& options);

}  // namespace offing::mesh_tools
