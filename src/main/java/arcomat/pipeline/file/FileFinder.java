package arcomat.pipeline.file;

import arcomat.pipeline.PathNames;
import arcomat.source.Diagnostic;

import java.io.IOException;
import java.nio.file.DirectoryStream;
import java.nio.file.FileSystemException;
import java.nio.file.FileSystemLoopException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;

/**
 * Finds the model files behind the paths that a user names. Folders are searched in the order of
 * names; every file is found once, however many paths and links lead to it; links are followed, but
 * no folder is entered twice, so that links in circles end.
 */
public final class FileFinder {
    /**
     * @param path where the file is
     * @param shown how the user knows it
     */
    public record Found(Path path, String shown) {}

    /** By which files of models are known; a component of an older tool may end in the last. */
    private static final List<String> ENDINGS =
            List.of(".arc", ".cd", ".ioautomaton", ".mt", ".maa");

    private final PathNames names;
    private final List<String> endings;
    private final String what;
    private final List<Found> files = new ArrayList<>();
    private final List<Diagnostic> findings = new ArrayList<>();
    private final Set<Path> seen = new HashSet<>();
    private final Deque<Path> open = new ArrayDeque<>();

    /** Model files come across, those that were already found included. */
    private int met;

    /**
     * @param names what relative paths start from
     */
    public FileFinder(PathNames names) {
        this(names, ENDINGS, "model file");
    }

    /**
     * Finds model files, and those that guests read.
     *
     * @param further endings of theirs
     */
    public FileFinder(PathNames names, List<String> further) {
        this(names, Stream.concat(ENDINGS.stream(), further.stream()).toList(), "model file");
    }

    /**
     * Finds other files.
     *
     * @param endings of their names
     * @param what one of them is, in words
     */
    public FileFinder(PathNames names, List<String> endings, String what) {
        this.names = names;
        this.endings = List.copyOf(endings);
        this.what = what;
    }

    /** By the ending of its name. */
    public static boolean isModelFile(Path file) {
        return ends(file, ENDINGS);
    }

    private static boolean ends(Path file, List<String> endings) {
        String name = String.valueOf(file.getFileName()); // the root of a file system has none
        return endings.stream().anyMatch(name::endsWith);
    }

    private String listing() {
        return String.join(", ", endings);
    }

    /** What was found so far, in the order of finding. */
    public List<Found> files() {
        return files;
    }

    /** About paths that lead nowhere, and folders that cannot be searched. */
    public List<Diagnostic> findings() {
        return findings;
    }

    /** Takes a path as written: a file of whatever name, or a folder to be searched. */
    public void find(String written) {
        Path path = names.resolve(written);
        boolean absolute = Path.of(written).isAbsolute();
        String shown = names.shown(path, absolute);
        if (!names.fence().permits(path)) {
            unreadable(shown, names.fence().refusal());
        } else if (PathNames.real(path).getParent() == null) {
            unreadable(
                    shown,
                    "is the whole file system, and would be searched for days; name the folder of"
                            + " the models");
        } else if (Files.isDirectory(path)) {
            if (!seen.contains(PathNames.real(path))) {
                int before = met + findings.size();
                searchFolder(path, shown, absolute);
                if (met + findings.size() == before) {
                    unreadable(shown, "holds no " + what + "s (" + listing() + ")");
                }
            }
        } else if (Files.exists(path)) {
            if (ends(path, endings)) {
                addFile(path, shown);
            } else {
                unreadable(shown, "is not a " + what + "; their names end in " + listing());
            }
        } else {
            missing(path, shown);
        }
    }

    private void missing(Path path, String shown) {
        if (Files.isSymbolicLink(path)) {
            brokenLink(path, shown);
        } else {
            unreadable(shown, "does not exist");
        }
    }

    private void searchFolder(Path folder, String shown, boolean absolute) {
        Path real = PathNames.real(folder);
        if (open.contains(real)) {
            findings.add(
                    FileFindings.warning(
                            FileFindings.LINK_LOOP,
                            shown,
                            "this link leads back to a folder that contains it; it is not"
                                    + " followed"));
            return;
        }
        if (!seen.add(real)) {
            return;
        }
        open.push(real);
        for (Path entry : entries(folder, shown)) {
            visit(entry, names.shown(entry, absolute), absolute);
        }
        open.pop();
    }

    private void visit(Path entry, String shown, boolean absolute) {
        if (entry.getFileName().toString().startsWith(".")) {
            return;
        }
        if (Files.isDirectory(entry)) {
            if (mayBeRead(entry, shown)) {
                searchFolder(entry, shown, absolute);
            }
        } else if (ends(entry, endings) && mayBeRead(entry, shown)) {
            if (Files.exists(entry)) {
                addFile(entry, shown);
            } else {
                missing(entry, shown);
            }
        }
    }

    private boolean mayBeRead(Path entry, String shown) {
        boolean may = names.fence().permits(entry);
        if (!may) {
            unreadable(shown, names.fence().refusal());
        }
        return may;
    }

    private void addFile(Path file, String shown) {
        met++;
        if (seen.add(PathNames.real(file))) {
            files.add(new Found(file, shown));
        }
    }

    private List<Path> entries(Path folder, String shown) {
        List<Path> entries = new ArrayList<>();
        try (DirectoryStream<Path> stream = Files.newDirectoryStream(folder)) {
            stream.forEach(entries::add);
        } catch (IOException | java.nio.file.DirectoryIteratorException e) {
            unreadable(shown, "cannot be listed: permission denied or the medium fails");
        }
        entries.sort(Comparator.comparing(p -> p.getFileName().toString()));
        return entries;
    }

    private void brokenLink(Path link, String shown) {
        if (isLoop(link)) {
            findings.add(
                    FileFindings.error(
                            FileFindings.LINK_LOOP,
                            shown,
                            "this link leads to itself; point it at a file or remove it"));
        } else {
            unreadable(shown, "is a link to a file that does not exist");
        }
    }

    private static boolean isLoop(Path link) {
        Set<Path> passed = new HashSet<>();
        Path at = link.toAbsolutePath().normalize();
        try {
            while (Files.isSymbolicLink(at)) {
                if (!passed.add(at)) {
                    return true;
                }
                at = at.resolveSibling(Files.readSymbolicLink(at)).normalize();
            }
            Files.readAttributes(
                    at,
                    java.nio.file.attribute.BasicFileAttributes.class,
                    LinkOption.NOFOLLOW_LINKS);
            return false;
        } catch (FileSystemLoopException loop) {
            return true;
        } catch (FileSystemException e) {
            return e.getReason() != null && e.getReason().contains("symbolic links");
        } catch (IOException e) {
            return false;
        }
    }

    private void unreadable(String shown, String what) {
        findings.add(FileFindings.error(FileFindings.UNREADABLE, shown, "'" + shown + "' " + what));
    }
}
