package arcomat.pipeline.guest;

import arcomat.check.guest.GuestLaws;
import arcomat.check.law.Law;
import arcomat.guest.BehaviourLanguage;
import arcomat.guest.FileKind;
import arcomat.guest.Guest;
import arcomat.guest.Importer;
import arcomat.guest.ReportForm;
import arcomat.guest.host.Guests.Form;
import arcomat.guest.host.Guests.Kind;
import arcomat.guest.host.Guests.Language;
import arcomat.guest.host.Guests.Question;
import arcomat.guest.host.Guests.Reader;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.WrongUse;
import arcomat.source.Sha256;
import arcomat.symbols.signatures.BehaviourReader;
import arcomat.syntax.Identifiers;

import java.io.IOException;
import java.io.InputStream;
import java.net.MalformedURLException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.security.CodeSource;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import java.util.ServiceConfigurationError;
import java.util.ServiceLoader;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.jar.JarFile;
import java.util.regex.Pattern;
import java.util.stream.Stream;

/**
 * What is at a path that {@code --with} names. Its classes see those of the tool; whatever they
 * throw while they introduce themselves is a reason to refuse them, and says whose fault it is.
 *
 * @param path as the user wrote it
 */
record GuestJar(String path, URLClassLoader loader, String identity) {
    /** What a guest brings. */
    record Arrival(
            GuestLaws laws,
            List<Question> questions,
            List<Language> languages,
            List<Kind> kinds,
            List<Reader> readers,
            SortedMap<String, String> library,
            List<Form> forms) {}

    private static final Pattern NAME = Pattern.compile("[\\p{L}\\p{N}][\\p{L}\\p{N}.-]{0,39}");
    private static final Pattern FORM =
            Pattern.compile("(?!(text|json|sarif|junit|github)$)[a-z][a-z0-9-]{0,39}");
    private static final Pattern ENDING =
            Pattern.compile("(?!\\.(arc|cd|ioautomaton|mt|maa)$)\\.\\w+");

    /** A path that leads nowhere else: no name in it begins with a dot. */
    private static final Pattern INSIDE = Pattern.compile("\\w[\\w.-]*(/\\w[\\w.-]*)*");

    private static final Pattern CODE = Pattern.compile("(?!ARC)[A-Z]{2,8}[0-9]{4}");

    /**
     * @throws WrongUse where nothing is there that can be read
     */
    static GuestJar open(String path, PathNames names) throws WrongUse {
        Path place = names.readable(path);
        if (!Files.exists(place)) {
            throw new WrongUse(
                    "there is no guest '%s'; --with names a jar, or a folder of classes", path);
        }
        try {
            URLClassLoader loader =
                    new URLClassLoader(new URL[] {url(place)}, Guest.class.getClassLoader());
            return new GuestJar(path, loader, content(place));
        } catch (IOException e) {
            throw new WrongUse(
                    "the guest '%s' cannot be read: %s", path, String.valueOf(e.getMessage()));
        }
    }

    private static URL url(Path place) throws MalformedURLException {
        return place.toUri().toURL();
    }

    /** A digest of all bytes: a guest that was compiled anew may find something else. */
    private static String content(Path place) throws IOException {
        if (Files.isRegularFile(place)) {
            new JarFile(place.toFile()).close(); // a class loader would find nothing in a torn one
        }
        List<Path> files;
        try (Stream<Path> all = Files.walk(place)) {
            files = all.filter(Files::isRegularFile).sorted().toList();
        }
        StringBuilder digests = new StringBuilder();
        for (Path file : files) {
            digests.append(place.relativize(file))
                    .append(' ')
                    .append(
                            HexFormat.of()
                                    .formatHex(Sha256.begin().digest(Files.readAllBytes(file))))
                    .append('\n');
        }
        return Sha256.hex(digests.toString());
    }

    /**
     * Those that the jar names as services.
     *
     * @throws WrongUse where there is none, or one of another version, or one that is not in order
     */
    List<Arrival> arrivals() throws WrongUse {
        List<Arrival> guests = new ArrayList<>();
        try {
            for (Guest guest : ServiceLoader.load(Guest.class, loader)) {
                if (isOurs(guest)) {
                    guests.add(arrival(guest));
                }
            }
        } catch (ServiceConfigurationError e) {
            throw ill(String.valueOf(e.getMessage()));
        } catch (LinkageError | RuntimeException e) {
            throw ill(e.toString());
        }
        if (guests.isEmpty()) {
            throw new WrongUse(
                    "there is no guest in '%s': the file META-INF/services/%s, which names its"
                            + " class, is missing",
                    path, Guest.class.getName());
        }
        return guests;
    }

    /** Where the tool is a part of somebody's process, that may have loaded the same jar before. */
    private boolean isOurs(Guest guest) {
        if (guest.getClass().getClassLoader() == loader) {
            return true;
        }
        CodeSource source = guest.getClass().getProtectionDomain().getCodeSource();
        return source != null
                && String.valueOf(source.getLocation()).equals(loader.getURLs()[0].toString());
    }

    private WrongUse ill(String reason) {
        return new WrongUse(
                "the guest '%s' cannot be asked what it brings: %s; tell who wrote it, or leave it"
                        + " out",
                path, reason);
    }

    private Arrival arrival(Guest guest) throws WrongUse {
        if (guest.api() != Guest.API) {
            throw new WrongUse(
                    "the guest '%s' was made for version %d of arcomat-api, and this is version"
                            + " %d; it has to be compiled anew",
                    path, guest.api(), Guest.API);
        }
        String name = guest.name();
        if (!NAME.matcher(name).matches()) {
            throw new WrongUse(
                    "the guest in '%s' calls itself '%s'; a name has letters, digits, dots and"
                            + " hyphens, 40 at most",
                    path, name);
        }
        List<Language> languages = languages(name, guest.languages());
        List<Kind> kinds = kinds(name, guest.importers());
        List<Reader> readers = readers(name, guest.fileKinds());
        List<Question> questions =
                guest.analyses().stream()
                        .map(each -> new Question(name, each.codes(), each))
                        .toList();
        List<String> others =
                Stream.of(
                                languages.stream().map(Language::codes),
                                kinds.stream().map(Kind::codes),
                                readers.stream().map(Reader::codes),
                                questions.stream().map(Question::codes))
                        .flatMap(Function.identity())
                        .flatMap(List::stream)
                        .toList();
        return new Arrival(
                laws(name, guest.laws(), others, languages),
                questions,
                languages,
                kinds,
                readers,
                library(name, guest.library()),
                forms(name, guest.reportForms()));
    }

    private GuestLaws laws(
            String name, List<Law> laws, List<String> others, List<Language> languages)
            throws WrongUse {
        BehaviourReader reader = SituatedBehaviours.in(languages);
        GuestLaws all = new GuestLaws(name, identity, laws, others, reader, this::page);
        for (String code : all.codes()) {
            if (!CODE.matcher(code).matches()) {
                throw new WrongUse(
                        "guest '%s' has findings with the code '%s'; the code of a guest has two to"
                                + " eight capital letters, other than ARC, and four digits",
                        name, code);
            }
        }
        return all;
    }

    private static List<Language> languages(String name, List<BehaviourLanguage> brought)
            throws WrongUse {
        List<Language> languages = new ArrayList<>();
        for (BehaviourLanguage each : brought) {
            String keyword = each.keyword();
            if (!Identifiers.isFree(keyword)) {
                throw new WrongUse(
                        "behaviours of guest '%s' begin with '%s'; it has to be a name, and none of"
                                + " Arcomat's own words",
                        name, keyword);
            }
            languages.add(
                    new Language(name, keyword, each.codes(), new TreeMap<>(each.words()), each));
        }
        return languages;
    }

    private static List<Form> forms(String guest, List<ReportForm> brought) throws WrongUse {
        List<Form> forms = new ArrayList<>();
        for (ReportForm each : brought) {
            String form = each.form();
            if (!FORM.matcher(form).matches()) {
                throw new WrongUse(
                        "a form of report of guest '%s' is called '%s'; such a name has small"
                                + " letters, digits and hyphens, begins with a letter, and is none"
                                + " of the tool's own",
                        guest, form);
            }
            forms.add(new Form(guest, form, each));
        }
        return forms;
    }

    private static List<Kind> kinds(String name, List<Importer> brought) throws WrongUse {
        List<Kind> kinds = new ArrayList<>();
        for (Importer each : brought) {
            String word = each.kind();
            if (!NAME.matcher(word).matches()) {
                throw new WrongUse(
                        "guest '%s' imports what it calls '%s'; a kind has letters, digits, dots"
                                + " and hyphens, 40 at most",
                        name, word);
            }
            Kind kind = new Kind(name, word, each.endings(), each.codes(), each);
            if (kind.endings().isEmpty()
                    || !kind.endings().stream().allMatch(ending -> ending.matches("\\.\\w+"))) {
                throw new WrongUse(
                        "guest '%s' does not say how files of kind '%s' end; an ending is a dot and"
                                + " letters",
                        name, word);
            }
            kinds.add(kind);
        }
        return kinds;
    }

    private static List<Reader> readers(String name, List<FileKind> brought) throws WrongUse {
        List<Reader> readers = new ArrayList<>();
        for (FileKind each : brought) {
            Reader reader = new Reader(name, each.endings(), each.codes(), each);
            if (reader.endings().isEmpty()
                    || !reader.endings().stream().allMatch(ENDING.asMatchPredicate())) {
                throw new WrongUse(
                        "guest '%s' reads files that end in '%s'; an ending is a dot and letters,"
                                + " and none of Arcomat's own",
                        name, String.join("', '", reader.endings()));
            }
            readers.add(reader);
        }
        return readers;
    }

    /** Texts by their paths in the model root. */
    private SortedMap<String, String> library(String name, List<String> paths) throws WrongUse {
        SortedMap<String, String> texts = new TreeMap<>();
        for (String path : paths) {
            Optional<String> text =
                    INSIDE.matcher(path).matches() ? text("library/" + path) : Optional.empty();
            if (text.isEmpty()) {
                throw new WrongUse(
                        "guest '%s' has a library with '%s', and there is no such file in its"
                                + " folder 'library'",
                        name, path);
            }
            texts.put(path, text.get());
        }
        return texts;
    }

    /** What the guest says about a code of its own. */
    private Optional<String> page(String code) {
        return text("explain/" + code + ".md");
    }

    private Optional<String> text(String resource) {
        try (InputStream in = loader.getResourceAsStream(resource)) {
            return in == null
                    ? Optional.empty()
                    : Optional.of(new String(in.readAllBytes(), StandardCharsets.UTF_8));
        } catch (IOException e) {
            return Optional.empty();
        }
    }
}
