package arcomat.editor.name;

import arcomat.check.naming.Definitions;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.Span;
import arcomat.symbols.occurrences.Referent;

import java.util.Map;
import java.util.TreeMap;

/** A file is named after what it defines, and has to be so afterwards. */
final class FileMoves {
    private FileMoves() {}

    /** Returns new paths by old ones; paths that stay are not among them. */
    static Map<String, String> of(OpenModels models, Map<Referent, String> names)
            throws RenameRefused {
        Map<String, String> moves = new TreeMap<>();
        for (Map.Entry<Referent, String> each : names.entrySet()) {
            Span place = each.getKey().declaration().orElseThrow();
            String path = place.file().path();
            if (isDefinition(models, place) && baseName(path).equals(each.getKey().name())) {
                String moved = renamed(path, each.getValue());
                if (!moved.equals(path)) {
                    refuseTaken(models, path, moved);
                    moves.put(path, moved);
                }
            }
        }
        return moves;
    }

    private static boolean isDefinition(OpenModels models, Span place) {
        return models.parsed(place.file().path())
                .flatMap(parsed -> parsed.readable())
                .flatMap(unit -> Definitions.name(unit.definition()))
                .filter(name -> name.span().equals(place))
                .isPresent();
    }

    private static void refuseTaken(OpenModels models, String path, String moved)
            throws RenameRefused {
        if (models.source(moved).isPresent()) {
            throw new RenameRefused(
                    "'%s' would have to become '%s', which is there already; choose another name"
                            .formatted(path, moved));
        }
    }

    private static String baseName(String path) {
        String file = path.substring(path.lastIndexOf('/') + 1);
        int dot = file.lastIndexOf('.');
        return dot < 0 ? file : file.substring(0, dot);
    }

    private static String renamed(String path, String name) {
        int start = path.lastIndexOf('/') + 1;
        return path.substring(0, start) + name + path.substring(start + baseName(path).length());
    }
}
