package arcomat.editor.name;

import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Fix.TextEdit;
import arcomat.source.SourceFile;
import arcomat.symbols.occurrences.Occurrence;
import arcomat.symbols.occurrences.Referent;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;

/**
 * What is to be done so that things have new names.
 *
 * @param names the new names
 * @param written what is written where only a type stood, so that an implicit name becomes another
 * @param edits of each text, by its path; no two of one place
 * @param moves the new paths of files that are named after what they define
 */
public record RenamePlan(
        Map<Referent, String> names,
        Map<Referent, TextEdit> written,
        Map<String, List<TextEdit>> edits,
        Map<String, String> moves) {

    static RenamePlan of(OpenModels models, Map<Referent, String> names) throws RenameRefused {
        Map<String, List<TextEdit>> edits = new TreeMap<>();
        for (String path : filesWith(models, names.keySet())) {
            List<TextEdit> here = new ArrayList<>();
            for (Occurrence each : Mentions.in(models, path)) {
                String name = names.get(each.referent());
                if (name != null && !name.equals(each.span().text())) {
                    here.add(new TextEdit(each.span(), name));
                }
            }
            if (!here.isEmpty()) {
                edits.put(path, here);
            }
        }
        Map<Referent, TextEdit> written = ImplicitNames.written(names);
        for (TextEdit each : written.values()) {
            edits.computeIfAbsent(each.span().file().path(), any -> new ArrayList<>()).add(each);
        }
        return new RenamePlan(names, written, edits, FileMoves.of(models, names));
    }

    /** The files in which one of some names stands. */
    static Set<String> filesWith(OpenModels models, Collection<Referent> named) {
        Set<String> paths = new TreeSet<>();
        named.stream()
                .map(Referent::name)
                .distinct()
                .forEach(name -> Mentions.withWord(models, name).forEach(paths::add));
        return paths;
    }

    TextShift shift(String path) {
        return edits.containsKey(path) ? new TextShift(edits.get(path)) : TextShift.NONE;
    }

    /** The path that a file has in the end. */
    String path(String before) {
        return moves.getOrDefault(before, before);
    }

    /** The models after all of it. */
    OpenModels applied(OpenModels before) {
        Set<String> touched = new TreeSet<>(edits.keySet());
        touched.addAll(moves.keySet());
        List<SourceFile> texts = new ArrayList<>();
        for (String path : touched) {
            String text = before.source(path).orElseThrow().text();
            texts.add(new SourceFile(path(path), shift(path).applied(text)));
        }
        return before.with(new OpenModels.Edit(texts, List.of(), moves.keySet()));
    }
}
