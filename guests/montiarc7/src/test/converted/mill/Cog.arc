package mill;

/** A wheel with the usual teeth, and a number that is no number of teeth. */
component Cog(Integer number) extends Wheel() { }
