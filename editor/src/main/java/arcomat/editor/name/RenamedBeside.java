package arcomat.editor.name;

import arcomat.editor.desk.OtherTexts;
import arcomat.pipeline.PathNames;
import arcomat.source.Fix.TextEdit;
import arcomat.source.SourceFile;
import arcomat.symbols.occurrences.Referent;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.stream.Collectors;

/**
 * What a renaming means for texts that are no models. Worlds and campaigns name components by their
 * qualified names, and there a name is certain; all else that looks like a name is for somebody to
 * look at.
 *
 * @param edits of each text, by its path
 * @param mentions the files in which an old name stands that is left as it is, with that name
 */
public record RenamedBeside(Map<String, List<TextEdit>> edits, Map<String, Set<String>> mentions) {
    /** Files that are named in a message; somebody reads it on one line. */
    private static final int SHOWN = 8;

    private static final String REQUEST =
            "; it is left as it is there: look whether the same is meant";

    /** Kinds that worlds, campaigns and scripts may name; Java may name all. */
    private static final Set<Referent.Kind> NAMED_IN_WORLDS =
            Set.of(
                    Referent.Kind.COMPONENT,
                    Referent.Kind.PART,
                    Referent.Kind.TYPE,
                    Referent.Kind.CONSTANT);

    public static RenamedBeside of(RenamePlan plan, OtherTexts others) {
        RenamedBeside all = new RenamedBeside(new TreeMap<>(), new TreeMap<>());
        for (SourceFile text : others.texts()) {
            plan.names().forEach((referent, name) -> all.add(referent, name, text, others));
        }
        return all;
    }

    private void add(Referent referent, String name, SourceFile text, OtherTexts others) {
        boolean isJava = text.path().endsWith(".java");
        if (isJava || NAMED_IN_WORLDS.contains(referent.kind())) {
            boolean isCertain = !isJava && isCertain(referent, others);
            WordPlaces places = new WordPlaces(text, referent.name());
            for (int at : places.all()) {
                if (isCertain && places.isBehind(qualifier(referent), at) && !places.isNoted(at)) {
                    edits.computeIfAbsent(text.path(), any -> new ArrayList<>())
                            .add(new TextEdit(places.span(at), name));
                } else {
                    mentions.computeIfAbsent(referent.name(), any -> new TreeSet<>())
                            .add(text.path());
                }
            }
        }
    }

    /** A name without a package is a word like any other. */
    private static boolean isCertain(Referent referent, OtherTexts others) {
        return referent instanceof Referent.Component component
                && component.signature().qualifiedName().indexOf('.') >= 0
                && !others.isAmbiguous().test(component.signature().qualifiedName());
    }

    /** With its last dot. */
    private static String qualifier(Referent referent) {
        String name = ((Referent.Component) referent).signature().qualifiedName();
        return name.substring(0, name.lastIndexOf('.') + 1);
    }

    /**
     * What somebody has to look at; empty where there is nothing.
     *
     * @param root paths below it are shown from there
     */
    public Optional<String> warning(Path root) {
        if (mentions.isEmpty()) {
            return Optional.empty();
        }
        return Optional.of(
                mentions.entrySet().stream()
                        .map(each -> sentence(each.getKey(), each.getValue(), root))
                        .collect(Collectors.joining("; ", "", REQUEST)));
    }

    private static String sentence(String word, Set<String> files, Path root) {
        String shown =
                files.stream()
                        .limit(SHOWN)
                        .map(each -> new PathNames(root).shown(Path.of(each), false))
                        .collect(Collectors.joining(", "));
        String more = files.size() > SHOWN ? " and " + (files.size() - SHOWN) + " more" : "";
        return "'%s' also stands in %s%s".formatted(word, shown, more);
    }
}
