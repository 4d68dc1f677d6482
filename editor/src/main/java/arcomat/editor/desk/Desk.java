package arcomat.editor.desk;

import arcomat.editor.text.Positions;
import arcomat.guest.host.Guests;
import arcomat.pipeline.PathNames;
import arcomat.pipeline.beside.BesideText;
import arcomat.pipeline.check.Library;
import arcomat.pipeline.check.LibraryFolder;
import arcomat.pipeline.file.FileFinder;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.recheck.FirstLook;
import arcomat.pipeline.recheck.LibraryModels;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Diagnostic;
import arcomat.source.SourceFile;
import arcomat.symbols.names.Lazy;

import org.eclipse.lsp4j.TextDocumentContentChangeEvent;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;

/**
 * What lies on the desk: the folders of the workspace, and over them what is open on the screen.
 * Not to be used by more than one thread.
 */
public final class Desk {
    /** Made by tools: copies of models in there are nobody's to edit. */
    private static final Set<String> MADE = Set.of("build", "node_modules", "target");

    private final Set<Path> folders = new HashSet<>();

    /** Those of the folders that have not been read to their end yet, in that order. */
    private final Set<Path> unread = new LinkedHashSet<>();

    /** The texts of the first of these, where somebody has begun to read them. */
    private Optional<FilesToTake> reading = Optional.empty();

    /** Files in these that are on the screen already. */
    private final Set<Path> early = new LinkedHashSet<>();

    private final Map<Path, SourceFile> screen = new HashMap<>();

    /** Folders of models of others. */
    private List<Path> libraries = List.of();

    private final Guests guests;
    private final Roots roots;
    private final Lazy<Optional<Path>> library = new Lazy<>(Desk::writtenLibrary);

    /** Without guests. */
    public Desk() {
        this(Guests.NONE);
    }

    /**
     * @param guests who bring laws and behaviour languages
     */
    public Desk(Guests guests) {
        this.guests = guests;
        this.roots = new Roots(guests);
    }

    /**
     * From now on models may refer to those of others.
     *
     * @param modelRoots folders, absolute
     * @return what is to be said of the folders
     */
    public List<Diagnostic> referTo(List<Path> modelRoots) {
        libraries = List.copyOf(modelRoots);
        roots.referTo(LibraryModels.in(libraries, guests));
        return roots.libraries().findings();
    }

    /** Takes in all models of a folder, when somebody needs them. */
    public void add(Path folder) {
        if (folders.add(folder)) {
            unread.add(folder);
        }
    }

    /** Reads what has been added. */
    private void read() {
        while (readSome()) {}
    }

    /**
     * Reads some of what has been added, so that who comes in between has not to wait for all.
     *
     * @return whether there was something to be read
     */
    public boolean readSome() {
        if (unread.isEmpty()) {
            return false;
        }
        Path folder = unread.iterator().next();
        if (reading.isEmpty()) {
            reading = Optional.of(new FilesToTake(texts(folder)));
        }
        FilesToTake files = reading.get();
        files.some().ifPresentOrElse(roots::take, () -> haveRead(folder));
        return true;
    }

    private void haveRead(Path folder) {
        reading = Optional.empty();
        unread.remove(folder);
        if (unread.isEmpty()) {
            List<Path> open = List.copyOf(early);
            early.clear();
            open.forEach(file -> write(file, Objects.requireNonNull(screen.get(file)).text()));
        }
    }

    /** Also one that a guest reads. */
    private boolean isModel(Path file) {
        return FileFinder.isModelFile(file) || guests.reader(file.toString()).isPresent();
    }

    /** All models in a folder, but for those that have been on the screen before. */
    private Map<Path, FileReader.Read> texts(Path folder) {
        FileFinder finder = new FileFinder(new PathNames(folder), guests.endings());
        finder.find(folder.toString());
        return texts(
                finder.files().stream()
                        .map(FileFinder.Found::path)
                        .filter(file -> !isMade(folder, file))
                        .filter(file -> !screen.containsKey(file) || early.contains(file))
                        .toList());
    }

    private static Map<Path, FileReader.Read> texts(List<Path> files) {
        Map<Path, FileReader.Read> read = new ConcurrentHashMap<>();
        files.parallelStream()
                .forEach(file -> read.put(file, FileReader.read(file, file.toString())));
        return new TreeMap<>(read);
    }

    private static boolean isMade(Path folder, Path file) {
        for (Path part : folder.relativize(file)) {
            if (MADE.contains(part.toString())) {
                return true;
            }
        }
        return false;
    }

    /** Forgets a folder and the models in it, but for those that are open. */
    public void remove(Path folder) {
        read();
        folders.remove(folder);
        roots.remove(
                roots.files().stream()
                        .filter(file -> file.startsWith(folder) && !screen.containsKey(file))
                        .filter(file -> folders.stream().noneMatch(file::startsWith))
                        .toList());
    }

    /** From now on the text on the screen counts, not that on the disk. */
    public void open(Path file, String text) {
        if (unread.stream().anyMatch(file::startsWith)) {
            early.add(file);
            screen.put(file, new SourceFile(file.toString(), text));
            return;
        }
        read();
        boolean alone = roots.of(file).isEmpty() && folders.stream().noneMatch(file::startsWith);
        write(file, text);
        if (alone && isModel(file)) {
            roots.of(file).map(OpenModels::root).ifPresent(root -> addNeighbours(root, file));
        }
    }

    /**
     * What a file that is opened alone may refer to: its model root, or its folder where it has no
     * package.
     */
    private void addNeighbours(Path root, Path file) {
        if (!root.equals(file.getParent()) && root.getParent() != null) {
            roots.take(texts(root));
        }
    }

    /**
     * What is to be said of a file on the screen while others have still to be read; nothing where
     * all have been, or more is to be known first.
     */
    public Optional<FirstLook> firstLook(Path file) {
        return early.contains(file) && isModel(file)
                ? onScreen(file).flatMap(text -> roots.firstLook(file, text.text()))
                : Optional.empty();
    }

    private void write(Path file, String text) {
        SourceFile source = new SourceFile(file.toString(), text);
        screen.put(file, source);
        if (isModel(file)) {
            roots.take(Map.of(file, FileReader.Read.of(source)));
        }
    }

    /** Edits a text on the screen, one change after the other. */
    public void change(Path file, List<TextDocumentContentChangeEvent> changes) {
        read();
        SourceFile source = screen.get(file);
        if (source == null) {
            return;
        }
        for (TextDocumentContentChangeEvent change : changes) {
            source = new SourceFile(source.path(), changed(source, change));
        }
        write(file, source.text());
    }

    private static String changed(SourceFile before, TextDocumentContentChangeEvent change) {
        if (change.getRange() == null) {
            return change.getText();
        }
        var span = Positions.span(before, change.getRange());
        return before.text().substring(0, span.start())
                + change.getText()
                + before.text().substring(span.end());
    }

    /** From now on what is on the disk counts. */
    public void close(Path file) {
        read();
        screen.remove(file);
        changedOnDisk(List.of(file));
    }

    /** Something happened to files; what is on the screen stays what it is. */
    public void changedOnDisk(Collection<Path> files) {
        read();
        List<Path> others =
                files.stream().filter(file -> !screen.containsKey(file) && isModel(file)).toList();
        if (files.stream().anyMatch(roots.libraries()::holds)) {
            referTo(libraries);
        }
        roots.remove(others.stream().filter(file -> !Files.isRegularFile(file)).toList());
        roots.take(texts(others.stream().filter(Files::isRegularFile).toList()));
    }

    /** What a question about a file is about; nothing where it is no model that could be read. */
    public Optional<View> view(Path file) {
        read();
        return roots.of(file).flatMap(models -> view(models, Roots.path(models, file)));
    }

    private Optional<View> view(OpenModels models, String path) {
        return models.source(path)
                .map(
                        source ->
                                new View(
                                        models,
                                        source,
                                        models.parsed(path).orElseThrow(),
                                        each -> place(models, each)));
    }

    /** Where editors find a file of some models; the tool's are written for them. */
    public Path place(OpenModels models, String path) {
        return isOfTool(models, path) && library.get().isPresent()
                ? library.get().get().resolve(Library.below(path))
                : models.root().resolve(path);
    }

    private static Optional<Path> writtenLibrary() {
        try {
            return Optional.of(LibraryFolder.written());
        } catch (IOException cannotWrite) {
            return Optional.empty();
        }
    }

    private static boolean isOfTool(OpenModels models, String path) {
        return models.isLibrary(path) && Library.isShown(path);
    }

    /**
     * Whether findings are for whoever works here: those of others are, where somebody looks at
     * them; of libraries that are not looked at, errors are, which is all that is found there.
     */
    public boolean isShown(OpenModels models, String path) {
        Path file = models.root().resolve(path);
        boolean ofOthers = LibraryFolder.holds(file) || isOfLibrary(file);
        if (models.isLibrary(path)) {
            return !isOfTool(models, path) && ofOthers && !screen.containsKey(file);
        }
        return !ofOthers || screen.containsKey(file);
    }

    /** Whoever has a library in the workspace works on it, too, unless a build has put it there. */
    private boolean isOfLibrary(Path file) {
        return roots.libraries().holds(file)
                && folders.stream()
                        .noneMatch(folder -> file.startsWith(folder) && !isMade(folder, file));
    }

    /** The text on the screen, of whatever kind. */
    public Optional<SourceFile> onScreen(Path file) {
        return Optional.ofNullable(screen.get(file));
    }

    /** What lies beside some models, in their folder and in those of the workspace. */
    public OtherTexts around(OpenModels models) {
        Set<Path> around = new HashSet<>(folders);
        around.add(models.root());
        return new OtherTexts(
                new TextsInFolders(MADE::contains, screen).in(around),
                name -> isDefinedBeside(models, name));
    }

    private boolean isDefinedBeside(OpenModels models, String component) {
        return roots.all().stream()
                .filter(each -> !each.root().equals(models.root()))
                .anyMatch(each -> !each.workspace().components(component).isEmpty());
    }

    /** A text beside models that is on the screen, by what its name says that it is. */
    public Optional<BesideText> beside(Path file) {
        return onScreen(file)
                .flatMap(text -> new Beside(this::onScreen, models()).text(file, text));
    }

    /** All that is on the screen. */
    public Set<Path> onScreen() {
        return Set.copyOf(screen.keySet());
    }

    /** All models, by their roots. */
    public Collection<OpenModels> models() {
        read();
        return roots.all();
    }

    /**
     * Checks what has changed and what that touches.
     *
     * @param goOn asked now and then; it may throw what ends the work until the next time
     */
    public void check(Runnable goOn) {
        read();
        roots.check(goOn);
    }

    /** The same of what is on the screen; the rest stays due. */
    public void checkScreen(Runnable goOn) {
        read();
        roots.check(screen.keySet(), goOn);
    }

    /**
     * Checks some of what is due, where something is.
     *
     * @return whether something was
     */
    public boolean checkSome(Runnable goOn) {
        return roots.checkSome(goOn);
    }
}
