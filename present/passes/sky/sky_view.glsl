// The sky's tables as every pass binds them; sky_radiance() and sky_sun_disc() read them (kernels/sky/clear_sky.clh).
uniform sampler2D view_table;
uniform sampler2D depth_table;
