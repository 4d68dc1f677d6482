package arcomat.docs;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/**
 * A block of code in a page of Markdown.
 *
 * @param language the first word behind the opening fence
 * @param title the rest of that line
 * @param line number of its first line in the page, from 1
 */
record Fence(String language, String title, List<String> body, int line) {
    static List<Fence> of(Path page) throws IOException {
        List<String> lines = Files.readAllLines(page);
        List<Fence> fences = new ArrayList<>();
        for (int i = 0; i < lines.size(); i++) {
            String head = lines.get(i);
            if (head.startsWith("```")) {
                int first = i + 1;
                do {
                    i++;
                } while (!lines.get(i).equals("```"));
                String[] words = head.substring(3).split(" ", 2);
                String title = words.length > 1 ? words[1] : "";
                fences.add(new Fence(words[0], title, lines.subList(first, i), first + 1));
            }
        }
        return fences;
    }

    String text() {
        return String.join("\n", body) + "\n";
    }
}
