package arcomat.site;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/** Models that others may refer to: those of the model library and of the case study. */
record Shelf(List<Book> books) {
    /**
     * A model.
     *
     * @param folder its package; nothing if it has none
     */
    record Book(String path, String folder, String name, String text) {
        private static final Pattern TYPE =
                Pattern.compile("\\b(?:enum|class|interface|type)\\s+(\\w+)");

        static Book of(String path, String text) {
            String file = path.substring(path.lastIndexOf('/') + 1);
            return new Book(
                    path, Fenced.packageOf(text), file.substring(0, file.lastIndexOf('.')), text);
        }

        /** Whether it may be the one that a text means: by its name, from where it is seen. */
        boolean isNamedBy(Book other) {
            boolean near = folder.equals(other.folder);
            return other != this
                    && (near || other.text.contains(folder + "."))
                    && (other.mentions(name) || near && types().anyMatch(other::mentions));
        }

        private boolean mentions(String word) {
            return Pattern.compile("\\b" + Pattern.quote(word) + "\\b").matcher(text).find();
        }

        /** What a class diagram declares, which its package sees without an import. */
        private Stream<String> types() {
            return path.endsWith(".cd")
                    ? TYPE.matcher(text).results().map(found -> found.group(1))
                    : Stream.empty();
        }
    }

    static Shelf of(Repository repository) throws IOException {
        List<Book> books = new ArrayList<>();
        for (String folder : List.of("lejos-runtime/nxt/src/main/arc", "models")) {
            for (Path path : repository.below(folder, ".arc", ".cd", ".ioautomaton")) {
                books.add(Book.of(Addresses.text(path), repository.read(path)));
            }
        }
        return new Shelf(books);
    }

    Shelf with(Collection<Book> more) {
        List<Book> all = new ArrayList<>(more);
        all.addAll(books);
        return new Shelf(all);
    }

    /** What some models need, directly or not, without themselves. */
    Set<Book> neededBy(Collection<Book> models) {
        Set<Book> needed = new LinkedHashSet<>();
        Deque<Book> open = new ArrayDeque<>(models);
        while (!open.isEmpty()) {
            Book reader = open.remove();
            for (Book book : books) {
                if (!models.contains(book) && book.isNamedBy(reader) && needed.add(book)) {
                    open.add(book);
                }
            }
        }
        return needed;
    }
}
