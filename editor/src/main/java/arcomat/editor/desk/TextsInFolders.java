package arcomat.editor.desk;

import arcomat.pipeline.file.FileReader;
import arcomat.source.SourceFile;

import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;

/**
 * Texts that are no models and may name what models define: worlds, campaigns, scripts, Java. They
 * are read when somebody asks, since hardly anybody does.
 *
 * @param isMade tells folders that are nobody's to edit, by their names
 * @param screen texts that count instead of those on the disk
 */
record TextsInFolders(Predicate<String> isMade, Map<Path, SourceFile> screen) {
    private static final List<String> ENDINGS = List.of(".world", ".campaign", ".script", ".java");

    /** Their paths are absolute. */
    List<SourceFile> in(Set<Path> folders) {
        Set<Path> files = new TreeSet<>();
        folders.forEach(folder -> find(folder, files));
        return files.stream().flatMap(file -> text(file).stream()).toList();
    }

    private Optional<SourceFile> text(Path file) {
        SourceFile shown = screen.get(file);
        return shown == null ? FileReader.read(file, file.toString()).file() : Optional.of(shown);
    }

    private void find(Path folder, Set<Path> found) {
        try {
            Files.walkFileTree(folder, new Visitor(found));
        } catch (IOException gone) {
            // What cannot be listed cannot be looked at.
        }
    }

    private final class Visitor extends SimpleFileVisitor<Path> {
        private final Set<Path> found;

        private Visitor(Set<Path> found) {
            this.found = found;
        }

        @Override
        public FileVisitResult preVisitDirectory(Path folder, BasicFileAttributes attributes) {
            String name = String.valueOf(folder.getFileName());
            return isMade.test(name) || name.startsWith(".")
                    ? FileVisitResult.SKIP_SUBTREE
                    : FileVisitResult.CONTINUE;
        }

        @Override
        public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
            if (ENDINGS.stream().anyMatch(file.toString()::endsWith)) {
                found.add(file);
            }
            return FileVisitResult.CONTINUE;
        }

        @Override
        public FileVisitResult visitFileFailed(Path file, IOException failure) {
            return FileVisitResult.CONTINUE;
        }
    }
}
