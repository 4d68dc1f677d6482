package arcomat.sim.load;

/**
 * A line of a program's source at whose beginning is noted that a run has come to it, without
 * taking any of the program's time, memory or calls: whether it is noted or not, the program does
 * the same.
 *
 * @param type full name of the class that was made of the source
 * @param line from 1; the class file tells where it begins
 * @param number under which it is noted, from 0; several lines may have the same
 */
public record LineProbe(String type, int line, int number) {}
