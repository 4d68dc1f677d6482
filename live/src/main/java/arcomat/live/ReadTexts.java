package arcomat.live;

import arcomat.pipeline.recheck.OpenModels.Draft;
import arcomat.pipeline.recheck.ReadModels;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;
import arcomat.symbols.names.Lazy;
import arcomat.syntax.Parsed;
import arcomat.syntax.Parser;
import arcomat.translate.HouseLanguages;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;

/**
 * Texts with what could be read of them. After a key one of many is another, and only that is read.
 */
final class ReadTexts implements ReadModels {
    static final ReadTexts NONE = new ReadTexts(Map.of());

    private final Map<SourceFile, Parsed> all;
    private final Map<String, Parsed> parsed = new LinkedHashMap<>();
    private final Map<String, SourceFile> sources = new LinkedHashMap<>();
    private final Lazy<Workspace> workspace = new Lazy<>(this::around);

    private ReadTexts(Map<SourceFile, Parsed> all) {
        this.all = Collections.unmodifiableMap(all);
        all.forEach(
                (file, read) -> {
                    parsed.put(file.path(), read);
                    sources.put(file.path(), file);
                });
    }

    /** In the order in which they were given. */
    Map<SourceFile, Parsed> all() {
        return all;
    }

    /** These texts; those that were there before are not read again. */
    ReadTexts with(List<SourceFile> files) {
        Map<SourceFile, Parsed> read = new LinkedHashMap<>();
        for (SourceFile file : files) {
            Parsed known = all.get(file);
            read.put(file, known == null ? Parser.parseHere(file) : known);
        }
        return new ReadTexts(read);
    }

    @Override
    public Set<String> paths() {
        return Collections.unmodifiableSet(sources.keySet());
    }

    @Override
    public Optional<SourceFile> source(String path) {
        return Optional.ofNullable(sources.get(path));
    }

    @Override
    public Optional<Parsed> parsed(String path) {
        return Optional.ofNullable(parsed.get(path));
    }

    /** The same one each time, since what it tells apart are its own things. */
    @Override
    public Workspace workspace() {
        return workspace.get();
    }

    private Workspace around() {
        return Draft.around(parsed, HouseLanguages.readerHere());
    }

    /** What names would mean if a file had another text. */
    Draft draft(SourceFile text) {
        return Draft.of(parsed, text.path(), Parser.parseHere(text), HouseLanguages.readerHere());
    }
}
