package arcomat.plugin;

import java.util.List;

/**
 * What came of a command of the tool.
 *
 * @param status its exit status
 * @param out what it found, as text for people
 * @param err its complaints about how it was used, and how it went about its work
 */
public record CommandResult(int status, String out, String err) {
    private static final int FINE = 0;
    private static final int WRONG_USE = 2;
    private static final String COMPLAINT = "arcomat: ";

    public boolean isFine() {
        return status == FINE;
    }

    /** Whether it could not do its work; else the models are not as they should be. */
    public boolean isWrongUse() {
        return status == WRONG_USE;
    }

    /** Why it failed, in one sentence; what leads to it is what it found. */
    public String failure() {
        return isWrongUse() ? complaint() : summary();
    }

    /** The last line, which says it all in short. */
    public String summary() {
        List<String> lines = out.lines().filter(line -> !line.isBlank()).toList();
        return lines.isEmpty() ? "exit status " + status : lines.get(lines.size() - 1);
    }

    /** Whether there is more to tell than the last line does. */
    public boolean hasDetails() {
        return out.lines().filter(line -> !line.isBlank()).count() > 1;
    }

    /** Why it could not do its work: how it was used, or what it could not read. */
    private String complaint() {
        return err.lines()
                .filter(line -> line.startsWith(COMPLAINT))
                .map(line -> line.substring(COMPLAINT.length()))
                .findFirst()
                .orElseGet(() -> out.isBlank() ? err.strip() : summary());
    }
}
