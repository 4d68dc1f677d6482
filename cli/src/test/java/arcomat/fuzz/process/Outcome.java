package arcomat.fuzz.process;

import java.util.List;
import java.util.Optional;

/**
 * How a call ended.
 *
 * @param status the exit status; nothing where it did not end and was ended
 * @param stray what reached the streams of the process past the tool's own
 * @param seconds that it kept a processor busy
 */
record Outcome(Optional<Integer> status, String out, String err, String stray, double seconds) {
    String said() {
        return String.join("\n", List.of(out, err, stray));
    }
}
