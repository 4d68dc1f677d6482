package arcomat.fuzz.process;

import java.util.List;
import java.util.SortedMap;

/**
 * What a process is given.
 *
 * @param files of the folder that it is started in
 * @param calls one after the other in that folder
 * @param bytes how many of them are somebody else's: the models, the jar ..
 */
record Input(SortedMap<String, byte[]> files, List<Call> calls) {
    long bytes() {
        return files.values().stream().mapToLong(content -> content.length).sum();
    }
}
