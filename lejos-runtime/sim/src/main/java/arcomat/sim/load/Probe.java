package arcomat.sim.load;

/**
 * A method of a program at whose beginning and end its observer is told, without taking any of the
 * program's time, memory or calls: whoever looks, the program does the same. Who leaves by an
 * exception has no end.
 *
 * @param type full name of the class that has the method
 * @param method its name; it is not static
 */
public record Probe(String type, String method) {}
