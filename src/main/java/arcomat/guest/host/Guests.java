package arcomat.guest.host;

import arcomat.check.LawBook;
import arcomat.guest.AutomatonAnalysis;
import arcomat.guest.BehaviourLanguage;
import arcomat.guest.FileKind;
import arcomat.guest.Importer;
import arcomat.guest.ReportForm;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Who is there besides the tool itself.
 *
 * @param laws the tool's and theirs
 * @param questions about automata, besides the tool's
 * @param languages that behaviours may be written in, besides automata and tables
 * @param kinds of models that can be read once
 * @param readers of files that are read each time
 * @param libraries model roots that models may refer to
 * @param forms in which results are written, besides the tool's
 * @param paths where they came from, as the user wrote them
 */
public record Guests(
        LawBook laws,
        List<Question> questions,
        List<Language> languages,
        List<Kind> kinds,
        List<Reader> readers,
        List<String> libraries,
        List<Form> forms,
        List<String> paths) {
    /** Nobody. */
    public static final Guests NONE =
            new Guests(
                    LawBook.OWN,
                    List.of(),
                    List.of(),
                    List.of(),
                    List.of(),
                    List.of(),
                    List.of(),
                    List.of());

    public Guests {
        questions = List.copyOf(questions);
        languages = List.copyOf(languages);
        kinds = List.copyOf(kinds);
        readers = List.copyOf(readers);
        libraries = List.copyOf(libraries);
        forms = List.copyOf(forms);
        paths = List.copyOf(paths);
    }

    /**
     * A form of report with the name of its guest.
     *
     * @param name what the form said that it is called, once
     */
    public record Form(String guest, String name, ReportForm form) {}

    /**
     * An analysis with the name of its guest.
     *
     * @param codes what the analysis said that it may find, once
     */
    public record Question(String guest, List<String> codes, AutomatonAnalysis analysis) {
        public Question {
            codes = List.copyOf(codes);
        }
    }

    /**
     * A language with the name of its guest.
     *
     * @param keyword what the language said it is, once
     * @param codes what it said that it may find
     * @param words of its texts, in alphabetical order, with what each says
     */
    public record Language(
            String guest,
            String keyword,
            List<String> codes,
            SortedMap<String, String> words,
            BehaviourLanguage translator) {
        public Language {
            codes = List.copyOf(codes);
            words = Collections.unmodifiableSortedMap(new TreeMap<>(words));
        }
    }

    /**
     * A reader of another language with the name of its guest.
     *
     * @param word what it said it is, once
     * @param endings of the files that it said it reads
     * @param codes what it said that it may find
     */
    public record Kind(
            String guest,
            String word,
            List<String> endings,
            List<String> codes,
            Importer importer) {
        public Kind {
            endings = List.copyOf(endings);
            codes = List.copyOf(codes);
        }
    }

    /**
     * A reader of files with the name of its guest.
     *
     * @param endings of the files that it said it reads
     * @param codes what it said that it may find
     */
    public record Reader(String guest, List<String> endings, List<String> codes, FileKind kind) {
        public Reader {
            endings = List.copyOf(endings);
            codes = List.copyOf(codes);
        }
    }

    /** How the names of files end that guests read each time. */
    public List<String> endings() {
        return readers.stream().flatMap(each -> each.endings().stream()).toList();
    }

    /** Who reads a file; nobody if it is one of the tool's own. */
    public Optional<Reader> reader(String path) {
        return readers.stream()
                .filter(each -> each.endings().stream().anyMatch(path::endsWith))
                .findFirst();
    }

    /** The language that begins with a word. */
    public Optional<Language> language(String keyword) {
        return languages.stream().filter(each -> each.keyword().equals(keyword)).findFirst();
    }
}
