package arcomat.cli;

import java.util.ArrayList;
import java.util.List;

/**
 * A session at the command line as a text file: files, commands and what they must print.
 *
 * <pre>
 * # what this shows
 * == file a/Robot.arc
 * component Robot {}
 * == bytes a/Bad.arc
 * C3 28
 * == link a/loop -> .
 * == program tools/mona
 * #!/bin/sh
 * == folder empty
 * $ arcomat check a
 * lines of standard output
 * ! lines of standard error
 * = 1
 * </pre>
 *
 * Lines {@code < text} before a command are typed by the user; what is asked comes on standard
 * error. The exit status follows the output of each command; {@code cat FILE} and {@code ls FOLDER}
 * look at what commands left behind, {@code javac FILES -d FOLDER} compiles guests.
 */
record Transcript(List<Section> sections) {
    /**
     * @param head the first line: {@code == file a/Robot.arc}, {@code $ arcomat check a}, or a
     *     comment
     * @param body the lines below it
     */
    record Section(String head, List<String> body) {
        boolean isCommand() {
            return head.startsWith("$ ");
        }

        boolean isTyped() {
            return head.startsWith("< ");
        }

        /**
         * {@code file}, {@code program}, {@code bytes}, {@code link} or {@code folder}; empty for
         * other sections.
         */
        String kind() {
            return head.startsWith("== ") ? head.split(" ")[1] : "";
        }

        /** What follows the kind, or the command without its prompt. */
        String rest() {
            return head.startsWith("== ") ? head.split(" ", 3)[2] : head.substring(2);
        }

        Section withBody(List<String> other) {
            return new Section(head, other);
        }
    }

    static Transcript parse(List<String> lines) {
        List<Section> sections = new ArrayList<>();
        for (String line : lines) {
            boolean comment = line.startsWith("# ") && !isInside(sections);
            if (comment || isHead(line)) {
                sections.add(new Section(line, new ArrayList<>()));
            } else {
                sections.get(sections.size() - 1).body().add(line);
            }
        }
        return new Transcript(sections);
    }

    private static boolean isHead(String line) {
        return line.startsWith("== ") || line.startsWith("$ ") || line.startsWith("< ");
    }

    /** Whether lines belong to a file or to output, where a number sign is text. */
    private static boolean isInside(List<Section> sections) {
        return !sections.isEmpty() && !sections.get(sections.size() - 1).head().startsWith("#");
    }

    String text() {
        StringBuilder text = new StringBuilder();
        for (Section section : sections) {
            text.append(section.head()).append('\n');
            section.body().forEach(line -> text.append(line).append('\n'));
        }
        return text.toString();
    }
}
