package arcomat.pipeline.watch;

import arcomat.pipeline.PathNames;
import arcomat.pipeline.file.FileFinder;

import org.jspecify.annotations.Nullable;

import java.io.IOException;
import java.nio.file.FileVisitOption;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.EnumSet;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;

/**
 * The files below the paths that the user named that have a say in any answer: models, worlds, and
 * what programs are made of besides.
 *
 * @param roots files and folders
 */
record WatchedFiles(List<Path> roots) {
    private static final String WORLD = ".world";

    /** Of which programs are made besides. */
    private static final List<String> BESIDE = List.of(".java", ".jar");

    static WatchedFiles of(List<String> written, PathNames names) {
        return new WatchedFiles(
                written.stream().map(path -> names.resolve(path).normalize()).toList());
    }

    static boolean isWorld(Path file) {
        return file.toString().endsWith(WORLD);
    }

    static boolean isBeside(Path file) {
        return BESIDE.stream().anyMatch(file.toString()::endsWith);
    }

    /** Whether a change of such a file can change an answer, wherever it lies. */
    static boolean matters(Path file) {
        String name = file.getFileName().toString();
        return !name.startsWith(".")
                && (FileFinder.isModelFile(file) || isWorld(file) || isBeside(file));
    }

    /** Whether it is one of the roots, or below one, and not hidden on the way. */
    boolean contains(Path path) {
        for (Path root : roots) {
            if (path.startsWith(root)) {
                Path inside = root.relativize(path);
                boolean hidden =
                        !path.equals(root) && inside.iterator().hasNext() && isHidden(inside);
                if (!hidden) {
                    return true;
                }
            }
        }
        return false;
    }

    private static boolean isHidden(Path inside) {
        for (Path part : inside) {
            if (part.toString().startsWith(".")) {
                return true;
            }
        }
        return false;
    }

    /** Every folder in a folder, itself included; links are followed, none twice. */
    static Set<Path> foldersIn(Path folder) {
        Set<Path> folders = new HashSet<>();
        walk(
                folder,
                new Visitor() {
                    @Override
                    public FileVisitResult preVisitDirectory(Path each, BasicFileAttributes any) {
                        if (isHiddenBelow(each, folder)) {
                            return FileVisitResult.SKIP_SUBTREE;
                        }
                        folders.add(each);
                        return FileVisitResult.CONTINUE;
                    }
                });
        return folders;
    }

    /** Files that matter, with what tells them from what was there before. */
    Map<Path, String> stamps() {
        Map<Path, String> stamps = new TreeMap<>();
        for (Path root : roots) {
            walk(
                    root,
                    new Visitor() {
                        @Override
                        public FileVisitResult preVisitDirectory(
                                Path each, BasicFileAttributes any) {
                            return isHiddenBelow(each, root)
                                    ? FileVisitResult.SKIP_SUBTREE
                                    : FileVisitResult.CONTINUE;
                        }

                        @Override
                        public FileVisitResult visitFile(Path file, BasicFileAttributes now) {
                            if (matters(file)) {
                                stamps.put(
                                        file,
                                        now.lastModifiedTime()
                                                + " "
                                                + now.size()
                                                + " "
                                                + now.fileKey());
                            }
                            return FileVisitResult.CONTINUE;
                        }
                    });
        }
        return stamps;
    }

    private static boolean isHiddenBelow(Path folder, Path root) {
        return !folder.equals(root) && folder.getFileName().toString().startsWith(".");
    }

    private static void walk(Path root, Visitor visitor) {
        try {
            Files.walkFileTree(
                    root, EnumSet.of(FileVisitOption.FOLLOW_LINKS), Integer.MAX_VALUE, visitor);
        } catch (IOException gone) {
            // What is not there any more has no files; the check says so.
        }
    }

    /** What cannot be looked at, or leads in a circle, is left to the check. */
    private abstract static class Visitor extends SimpleFileVisitor<Path> {
        @Override
        public FileVisitResult visitFileFailed(Path file, IOException reason) {
            return FileVisitResult.CONTINUE;
        }

        @Override
        public FileVisitResult postVisitDirectory(Path folder, @Nullable IOException reason) {
            return FileVisitResult.CONTINUE;
        }
    }
}
