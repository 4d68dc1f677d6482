package arcomat.fuzz.process;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;

/**
 * One call of the tool.
 *
 * @param written files and folders that the call may write, as its arguments name them
 * @param statuses that the help of the command allows
 */
record Call(List<String> arguments, Set<String> written, Set<Integer> statuses) {
    static Call of(Set<Integer> statuses, String... arguments) {
        return new Call(List.of(arguments), Set.of(), statuses);
    }

    Call writing(String... paths) {
        Set<String> all = new TreeSet<>(written);
        all.addAll(List.of(paths));
        return new Call(arguments, all, statuses);
    }

    /** With more arguments. */
    Call and(String... more) {
        List<String> all = new ArrayList<>(arguments);
        all.addAll(List.of(more));
        return new Call(all, written, statuses);
    }

    /** What cannot be fine. */
    Call refused() {
        Set<Integer> others = new TreeSet<>(statuses);
        others.remove(0);
        return new Call(arguments, written, others);
    }

    boolean mayWrite(String path) {
        return written.stream().anyMatch(w -> path.equals(w) || path.startsWith(w + "/"));
    }

    String command() {
        return arguments.get(0);
    }

    /** The value of an option that is written as an argument of its own, or nothing. */
    String option(String name) {
        int at = arguments.indexOf(name);
        return at < 0 ? "" : arguments.get(at + 1);
    }
}
