package arcomat.site;

import arcomat.site.Shelf.Book;

import org.commonmark.node.FencedCodeBlock;

import java.util.List;
import java.util.Set;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * A block of code.
 *
 * @param language the first word behind the opening fence
 * @param title the rest of that line: the file, most times
 */
record Fenced(String language, String title, String text) {
    private static final Set<String> MODELS = Set.of("arc", "cd", "ioautomaton", "mt");
    private static final String FILE = "//// ";
    private static final Pattern PACKAGE = Pattern.compile("(?m)^package ([\\w.]+);");
    private static final Pattern NAME =
            Pattern.compile(
                    "(?m)^(?:<<.*>> *)?(?:(?:public|abstract)"
                            + " )*(?:component|automaton|classdiagram|testsuite) (\\w+)");

    static Fenced of(FencedCodeBlock block) {
        String[] words = block.getInfo().strip().split(" ", 2);
        return new Fenced(words[0], words.length > 1 ? words[1] : "", block.getLiteral());
    }

    boolean isConsole() {
        return language.equals("console");
    }

    /** Whether it is written in a language of the tool. */
    boolean isModel() {
        return MODELS.contains(language);
    }

    /** Whether it is a file that the page's reader writes. */
    boolean isFile() {
        return title.contains(".") && !isPart();
    }

    /** Whether it is some lines of a file. */
    boolean isPart() {
        return title.startsWith("of ");
    }

    /** What stands above it. */
    String caption() {
        return title.isEmpty() ? language : title.replaceFirst("^of ", "from ");
    }

    /** Its folder as the names of models see it; nothing if it has none. */
    static String packageOf(String text) {
        Matcher found = PACKAGE.matcher(text);
        return found.find() ? found.group(1) : "";
    }

    /**
     * The models in it, by the paths that the page or their names give them; none where it defines
     * nothing. Lines such as {@code //// Motor.arc} begin files of their own.
     */
    List<Book> books() {
        if (isFile()) {
            return List.of(Book.of(title, text));
        }
        if (!text.startsWith(FILE)) {
            Matcher name = NAME.matcher(text);
            return name.find() ? List.of(named(name.group(1) + "." + language, text)) : List.of();
        }
        return Stream.of(text.split("(?m)^" + FILE))
                .filter(part -> !part.isEmpty())
                .map(part -> part.split("\n", 2))
                .map(part -> named(part[0].strip(), part[1]))
                .toList();
    }

    private static Book named(String file, String text) {
        String name = file.substring(file.lastIndexOf('/') + 1);
        String folder = packageOf(text).replace('.', '/');
        return Book.of(folder.isEmpty() ? name : folder + "/" + name, text);
    }
}
