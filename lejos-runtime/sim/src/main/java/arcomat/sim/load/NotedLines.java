package arcomat.sim.load;

import java.util.List;

/**
 * Lines of a class's source: each object of the class notes at their beginnings that it has come
 * there, without taking any of the program's time, memory or calls. Whether it notes it or not, the
 * program does the same. What is static notes nothing.
 *
 * @param type full name of the class that was made of the source
 * @param lines from 1, by the numbers under which they are noted; the class file tells where they
 *     begin. 0 for a number that is never noted
 */
public record NotedLines(String type, List<Integer> lines) {
    public NotedLines {
        lines = List.copyOf(lines);
    }
}
