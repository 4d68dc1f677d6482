package arcomat.check.structure.connector;

import arcomat.check.facts.Wording;
import arcomat.check.law.Check.Findings;
import arcomat.symbols.bodies.ConnectorSymbol;
import arcomat.symbols.bodies.ConnectorSymbol.End;
import arcomat.symbols.bodies.ConnectorSymbol.Ends;

import java.util.List;

/** What is said of ends that name a part, where it is not clear which of its ports is meant. */
final class PartsWithoutPorts {
    private static final int MOST_NAMED = 6;

    private static final String ONE_SOURCE =
            "'%s' is a part, and its targets ask for different ports of it; write a connector for"
                    + " each";

    private PartsWithoutPorts() {}

    static void report(ConnectorSymbol connector, Findings findings) {
        End source = connector.source();
        End target = connector.target();
        if (isUnknown(source) || isUnknown(target)) {
            return;
        }
        List<Ends> candidates = connector.candidates();
        if (source.namesPart() && target.namesPart()) {
            findings.report(source.span(), "%s", ofBoth(source, target, candidates));
        } else if (source.namesPart()) {
            findings.report(
                    source.span(),
                    "%s",
                    ofOne(source, target, candidates.stream().map(Ends::source).toList()));
        } else {
            findings.report(
                    target.span(),
                    "%s",
                    ofOne(target, source, candidates.stream().map(Ends::target).toList()));
        }
    }

    private static String ofBoth(End source, End target, List<Ends> candidates) {
        if (candidates.isEmpty()) {
            return "no output of '%s' fits an input of '%s', so none can be connected; write ports"
                            .formatted(source.text(), target.text())
                    + " that fit";
        }
        if (candidates.size() == 1) {
            return ONE_SOURCE.formatted(source.text());
        }
        return "'%s' and '%s' are parts, and several of their ports fit: %s; write which are meant"
                .formatted(
                        source.text(),
                        target.text(),
                        list(
                                candidates.stream()
                                        .map(
                                                each ->
                                                        each.source().text()
                                                                + " -> "
                                                                + each.target().text())
                                        .toList()));
    }

    private static String ofOne(End part, End other, List<End> candidates) {
        if (candidates.isEmpty()) {
            return "'%s' is a part, and none of its ports fits '%s'; connect one that does"
                    .formatted(part.text(), other.text());
        }
        if (candidates.size() == 1) {
            return ONE_SOURCE.formatted(part.text());
        }
        return "'%s' is a part, and several of its ports fit '%s': %s; write the one that is meant"
                .formatted(
                        part.text(),
                        other.text(),
                        list(candidates.stream().map(End::text).toList()));
    }

    /** Whether another law tells of the end, or of the component of its part. */
    private static boolean isUnknown(End end) {
        return end.namesPart()
                ? end.instance().orElseThrow().component().isEmpty()
                : !end.isResolved();
    }

    private static String list(List<String> names) {
        return Wording.firstOf(names.stream().map(name -> "'" + name + "'").toList(), MOST_NAMED);
    }
}
