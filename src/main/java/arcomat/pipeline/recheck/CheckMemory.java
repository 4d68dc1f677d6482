package arcomat.pipeline.recheck;

import arcomat.guest.host.Guests;
import arcomat.pipeline.Progress;
import arcomat.pipeline.check.ModelLoader;
import arcomat.pipeline.file.FileFinder.Found;
import arcomat.pipeline.file.FileReader;
import arcomat.pipeline.guest.ForeignBehaviours;
import arcomat.source.Sha256;
import arcomat.source.SourceFile;
import arcomat.syntax.Parsed;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.nio.file.attribute.FileTime;
import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;

/**
 * What a process that goes on keeps between two checks: texts, their digests and trees, and what
 * was found. A text is read again where the file has another time, length or identity, or where
 * somebody says that it has changed.
 */
public final class CheckMemory {
    /** Tells a file from what was there before, as well as a file system can. */
    private record Stamp(FileTime time, long length, @Nullable Object key) {}

    private record Known(Stamp stamp, FileReader.Read read) {}

    private record Digest(SourceFile file, String hash) {}

    private record Tree(SourceFile file, Parsed parsed) {}

    private final Map<Path, Known> texts = new ConcurrentHashMap<>();
    private final Map<String, Digest> digests = new ConcurrentHashMap<>();
    private final Map<String, Tree> trees = new ConcurrentHashMap<>();
    private final Guests guests;
    private Optional<CheckState> state = Optional.empty();

    /**
     * @param guests who know what some behaviours mean
     */
    public CheckMemory(Guests guests) {
        this.guests = guests;
    }

    /** Reads a file, or returns what was read of it. */
    FileReader.Read read(Found found) {
        Optional<Stamp> now = stamp(found.path());
        Known known = texts.get(found.path());
        if (known != null && now.isPresent() && known.stamp().equals(now.get())) {
            return known.read();
        }
        FileReader.Read read = FileReader.read(found.path(), found.shown());
        if (now.isPresent()) {
            texts.put(found.path(), new Known(now.get(), read));
        } else {
            texts.remove(found.path());
        }
        return read;
    }

    private static Optional<Stamp> stamp(Path path) {
        try {
            BasicFileAttributes now = Files.readAttributes(path, BasicFileAttributes.class);
            return Optional.of(new Stamp(now.lastModifiedTime(), now.size(), now.fileKey()));
        } catch (IOException gone) {
            return Optional.empty();
        }
    }

    /** These have changed, though it may not show: a clock may not have moved in between. */
    public void forget(Collection<Path> files) {
        files.forEach(texts::remove);
    }

    String hash(SourceFile file) {
        Digest known = digests.get(file.path());
        if (known != null && known.file() == file) {
            return known.hash();
        }
        String hash = Sha256.hex(file.text());
        digests.put(file.path(), new Digest(file, hash));
        return hash;
    }

    Parsed parsed(SourceFile file) {
        Tree known = trees.get(file.path());
        if (known != null && known.file() == file) {
            return known.parsed();
        }
        Parsed parsed = ForeignBehaviours.parse(file, guests);
        trees.put(file.path(), new Tree(file, parsed));
        return parsed;
    }

    /** In that order; those that are not known by several threads. */
    List<Parsed> parsed(List<SourceFile> files, Progress progress) {
        List<SourceFile> unknown = new ArrayList<>();
        for (SourceFile file : files) {
            Tree known = trees.get(file.path());
            if (known == null || known.file() != file) {
                unknown.add(file);
            }
        }
        List<Parsed> fresh = ModelLoader.parse(unknown, guests, progress);
        for (int i = 0; i < unknown.size(); i++) {
            trees.put(unknown.get(i).path(), new Tree(unknown.get(i), fresh.get(i)));
        }
        return files.stream()
                .map(file -> Objects.requireNonNull(trees.get(file.path())).parsed())
                .toList();
    }

    /** What the last check left, where it was asked the same. */
    Optional<CheckState> state(String key) {
        return state.filter(last -> last.key().equals(key));
    }

    /** What the last check left. */
    public Optional<CheckState> state() {
        return state;
    }

    void keep(CheckState now) {
        state = Optional.of(now);
    }
}
