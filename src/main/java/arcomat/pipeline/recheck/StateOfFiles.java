package arcomat.pipeline.recheck;

import arcomat.check.Review;
import arcomat.pipeline.check.CheckedModels;
import arcomat.pipeline.check.LoadedModels;
import arcomat.pipeline.check.WrittenNames;
import arcomat.pipeline.recheck.CheckState.File;
import arcomat.source.Diagnostic;
import arcomat.source.Sha256;
import arcomat.source.SourceFile;
import arcomat.source.Suppressed;
import arcomat.symbols.names.Outline;
import arcomat.syntax.Parsed;
import arcomat.tree.Recovered;
import arcomat.tree.Unit;
import arcomat.tree.Unit.Import;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Function;
import java.util.stream.Collectors;

/** What is to be remembered of files. */
record StateOfFiles(FilesAround around) {

    /** Of all files of a check. */
    List<File> of(CheckedModels models) {
        LoadedModels loaded = models.loaded();
        Set<String> named = Set.copyOf(loaded.named());
        Map<String, Unit> units = new HashMap<>();
        loaded.units().forEach(unit -> units.put(unit.file().path(), unit));
        Map<String, Recovered> recovered = new HashMap<>();
        loaded.recovered().forEach(each -> recovered.put(each.unit().file().path(), each));
        Map<String, List<Diagnostic>> findings = byFile(models.findings(), each -> each);
        Map<String, List<Suppressed>> suppressed = byFile(models.suppressed(), Suppressed::finding);
        List<File> files = new ArrayList<>();
        Set<String> unreadable = new HashSet<>(loaded.broken());
        for (SourceFile source : loaded.sources()) {
            String path = source.path();
            unreadable.remove(path);
            Parsed parsed =
                    new Parsed(
                            Optional.ofNullable(units.get(path)),
                            Optional.ofNullable(recovered.get(path)),
                            List.of());
            File file = of(source, parsed, named.contains(path));
            files.add(
                    file.with(
                            findings.getOrDefault(path, List.of()),
                            suppressed.getOrDefault(path, List.of())));
        }
        unreadable.forEach(path -> files.add(unreadable(path, named.contains(path))));
        return files;
    }

    /** Without findings. */
    File of(SourceFile source, Parsed parsed, boolean named) {
        Optional<Unit> readable = parsed.readable();
        return new File(
                source.path(),
                Sha256.hex(source.text()),
                named,
                readable.map(around::neededBy).orElse(List.of()),
                parsed.unit().map(Outline::of),
                readable.map(StateOfFiles::mentions).orElse(Set.of()),
                List.of(),
                List.of());
    }

    /** The findings about reading it are made afresh each time. */
    static File unreadable(String path, boolean named) {
        return new File(
                path, "", named, List.of(), Optional.empty(), Set.of(), List.of(), List.of());
    }

    private static Set<String> mentions(Unit unit) {
        Set<String> mentions = WrittenNames.in(unit.file().text());
        unit.imports().stream()
                .filter(Import::wildcard)
                .forEach(each -> mentions.add(FileInterface.allOf(each.name().text())));
        return mentions;
    }

    /**
     * Puts what was found into the states of files.
     *
     * @param affected the files that were checked
     * @param parsed what came of reading each of them, if it was read
     * @param files the states, by path
     */
    static void takeOver(
            Review review,
            Set<String> affected,
            Function<String, @Nullable Parsed> parsed,
            Map<String, File> files) {
        Map<String, List<Diagnostic>> findings = byFile(review.findings(), each -> each);
        Map<String, List<Suppressed>> suppressed = byFile(review.suppressed(), Suppressed::finding);
        for (String path : affected) {
            File file = Objects.requireNonNull(files.get(path));
            TreeSet<Diagnostic> found = new TreeSet<>(Diagnostic.ORDER);
            Optional.ofNullable(parsed.apply(path)).ifPresent(p -> found.addAll(p.findings()));
            found.addAll(findings.getOrDefault(path, List.of()));
            found.removeIf(each -> !file.named() && !each.isError());
            List<Suppressed> meant =
                    suppressed.getOrDefault(path, List.of()).stream()
                            .filter(each -> file.named() || each.finding().isError())
                            .toList();
            files.put(path, file.with(List.copyOf(found), meant));
        }
    }

    /**
     * @param finding of each
     */
    static <T> Map<String, List<T>> byFile(List<T> all, Function<T, Diagnostic> finding) {
        return all.stream()
                .collect(Collectors.groupingBy(each -> finding.apply(each).span().file().path()));
    }
}
