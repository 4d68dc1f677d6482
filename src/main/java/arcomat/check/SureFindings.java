package arcomat.check;

import arcomat.check.law.Law.Needs;
import arcomat.source.Diagnostic;
import arcomat.source.Span;
import arcomat.tree.Recovered;

import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.regex.Pattern;

/**
 * What may be said of the parts that could be read of a file with syntax errors: only what would
 * still be true if the gaps were filled.
 */
final class SureFindings {
    /** A connector, a transition or a row of a table: they have an arrow. */
    private static final Pattern ARROW = Pattern.compile("->|=>");

    /** Guards, and the connectors of a part, which is declared in front of them. */
    private static final Pattern BRACKETS = Pattern.compile("\\[[^\\]]*\\]");

    private static final Pattern DECLARING =
            Pattern.compile(
                    "automaton|class|component|enum|extends|import|in|input|out|output|port|ports"
                            + "|state|table|var|variable");

    private final Set<String> missing = new HashSet<>();
    private final boolean namesAreKnown;
    private final Map<String, Needs> needs;

    /**
     * @param needs of the laws, by their codes
     */
    SureFindings(Recovered recovered, Map<String, Needs> needs) {
        this.needs = needs;
        recovered.gaps().forEach(gap -> missing.addAll(words(gap)));
        namesAreKnown = recovered.gaps().stream().noneMatch(SureFindings::mayDeclare);
    }

    /** A misspelt word may be that of a declaration, and its name a misspelt one. */
    private static boolean mayDeclare(Span gap) {
        String outside = BRACKETS.matcher(gap.text()).replaceAll(" ");
        return !ARROW.matcher(outside).find()
                || words(gap).stream().anyMatch(w -> DECLARING.matcher(w).matches());
    }

    /** Whether nothing that a gap may hold is at the bottom of a finding. */
    boolean contains(Diagnostic finding) {
        return switch (needs.getOrDefault(finding.code(), Needs.ALL)) {
            case NOTHING ->
                    namesAreKnown || words(finding.span()).stream().noneMatch(missing::contains);
            case NAMES -> namesAreKnown;
            case ALL -> false;
        };
    }

    /** As they are, and as what is called after them: a type {@code Light} makes a port light. */
    private static Set<String> words(Span span) {
        Set<String> words = new HashSet<>();
        String text = span.text();
        for (int start = 0; start < text.length(); start++) {
            int end = start;
            while (end < text.length() && isOfName(text.charAt(end))) {
                end++;
            }
            if (end > start) {
                words.add(
                        Character.toLowerCase(text.charAt(start)) + text.substring(start + 1, end));
                start = end;
            }
        }
        return words;
    }

    /**
     * Numbers count as names here, and are none that is missing. No classes of letters: browsers do
     * without.
     */
    private static boolean isOfName(char letter) {
        return Character.isLetterOrDigit(letter) || letter == '_' || letter == '$';
    }
}
