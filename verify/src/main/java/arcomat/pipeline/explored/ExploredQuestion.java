package arcomat.pipeline.explored;

import arcomat.model.Automaton;
import arcomat.semantics.Promise;
import arcomat.source.Sha256;
import arcomat.source.SourceFile;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.TreeMap;

/**
 * What is asked, of which models, and by whom: only then numbers mean the same.
 *
 * @param version digest of the tool
 * @param asked in words
 * @param models the digests of model files, by path
 */
record ExploredQuestion(String version, String asked, Map<String, String> models) {
    private static final String FIRST = "what a search of arcomat has explored";
    private static final String VERSION = "version ";
    private static final String ASKED = "question ";
    private static final String MODEL = "model ";
    private static final int DIGITS = 64;

    ExploredQuestion {
        models = new TreeMap<>(models);
    }

    static ExploredQuestion ofRefinement(
            Promise left, Promise right, List<SourceFile> models, String version) {
        return of(side(left) + " refines " + side(right), models, version);
    }

    static ExploredQuestion ofPromises(List<SourceFile> models, String version) {
        return of("whether all promises are kept", models, version);
    }

    private static ExploredQuestion of(String asked, List<SourceFile> models, String version) {
        Map<String, String> digests = new TreeMap<>();
        for (SourceFile each : models) {
            digests.put(each.path(), Sha256.hex(each.text()));
        }
        return new ExploredQuestion(Sha256.hex(version), asked, digests);
    }

    private static String side(Promise side) {
        List<String> completions =
                side.automata().stream()
                        .map(Automaton::completion)
                        .map(each -> each.name().toLowerCase(Locale.ROOT))
                        .distinct()
                        .toList();
        return side.title()
                + (completions.isEmpty() ? "" : " (" + String.join(", ", completions) + ")");
    }

    /** As a file. */
    String text() {
        List<String> lines = new ArrayList<>(List.of(FIRST, VERSION + version, ASKED + asked));
        models.forEach((path, digest) -> lines.add(MODEL + digest + " " + path));
        return String.join("\n", lines) + "\n";
    }

    /** From such a file; empty where it is none. */
    static Optional<ExploredQuestion> parse(String text) {
        List<String> lines = text.lines().toList();
        if (lines.size() < 3
                || !lines.get(0).equals(FIRST)
                || !lines.get(1).startsWith(VERSION)
                || !lines.get(2).startsWith(ASKED)) {
            return Optional.empty();
        }
        Map<String, String> models = new TreeMap<>();
        for (String line : lines.subList(3, lines.size())) {
            int digest = MODEL.length();
            if (!line.startsWith(MODEL) || line.length() <= digest + DIGITS) {
                return Optional.empty();
            }
            models.put(
                    line.substring(digest + DIGITS + 1), line.substring(digest, digest + DIGITS));
        }
        String version = lines.get(1).substring(VERSION.length());
        return Optional.of(
                new ExploredQuestion(version, lines.get(2).substring(ASKED.length()), models));
    }

    /** In which way another one is no continuation of this one; empty where it is. */
    Optional<String> difference(ExploredQuestion other) {
        if (!asked.equals(other.asked)) {
            return Optional.of("another question: " + asked);
        }
        if (!version.equals(other.version)) {
            return Optional.of("another version of the tool");
        }
        if (models.equals(other.models)) {
            return Optional.empty();
        }
        TreeMap<String, String> all = new TreeMap<>(models);
        all.putAll(other.models);
        all.keySet().removeIf(path -> Objects.equals(models.get(path), other.models.get(path)));
        String path = all.firstKey();
        String how =
                !models.containsKey(path)
                        ? "was not among them"
                        : other.models.containsKey(path)
                                ? "has changed since"
                                : "is not among these any more";
        return Optional.of("other models: '%s' %s".formatted(path, how));
    }
}
