package arcomat.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;

/**
 * A block of code in a page of Markdown, perhaps indented as a part of a list.
 *
 * @param language the first word behind the opening fence
 * @param title the rest of that line
 * @param line number of its first line in the page, from 1
 */
record Fence(String language, String title, List<String> body, int line) {
    private static final String MARK = "```";
    private static final Set<String> MODELS = Set.of("arc", "cd", "ioautomaton", "mt");

    static List<Fence> of(Path page) throws IOException {
        List<String> lines = Files.readAllLines(page);
        List<Fence> fences = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            String head = lines.get(i).strip();
            if (head.startsWith(MARK)) {
                int indent = lines.get(i).indexOf(MARK);
                List<String> body = new ArrayList<>();
                int first = i + 1;
                for (i++; !lines.get(i).strip().equals(MARK); i++) {
                    body.add(lines.get(i).isBlank() ? "" : lines.get(i).substring(indent));
                }
                String[] words = head.substring(MARK.length()).split(" ", 2);
                String title = words.length > 1 ? words[1] : "";
                fences.add(new Fence(words[0], title, body, first + 1));
            }
        }
        return fences;
    }

    /** Whether it is written in a language of the tool. */
    boolean isModel() {
        return MODELS.contains(language);
    }

    String text() {
        return String.join("\n", body) + "\n";
    }
}
