package arcomat.analysis.automaton;

import arcomat.analysis.automaton.exploration.Knowledge;
import arcomat.analysis.automaton.exploration.Situation;
import arcomat.analysis.automaton.exploration.Visit;
import arcomat.analysis.reachability.Subject;
import arcomat.analysis.search.Moment;
import arcomat.analysis.search.system.ConfigurationText;
import arcomat.model.Letter;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.automaton.Configuration;
import arcomat.semantics.expression.Output;
import arcomat.semantics.expression.Sent;
import arcomat.source.Diagnostic;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * A question about one automaton. It is shown all that can happen, and says then what it found, and
 * how that comes about, in names instead of positions.
 */
abstract class Analysis {
    final Subject subject;

    Analysis(Subject subject) {
        this.subject = subject;
    }

    /**
     * Takes note of what may happen in a configuration; shorter ways come first. Of nothing, where
     * what is known afterwards answers the question.
     */
    void see(Situation situation) {}

    /** What was found, in text order; that something never happens only if all was seen. */
    abstract List<Finding> findings(Knowledge knowledge);

    /** A finding that is seen in a situation, on its letter. */
    final Finding finding(Diagnostic diagnostic, Situation situation) {
        return new Finding(
                diagnostic, trace(situation.visit()), Optional.of(letter(situation.letter())));
    }

    /** A finding that is seen in a configuration, whatever is read there. */
    final Finding finding(Diagnostic diagnostic, Visit visit) {
        return new Finding(diagnostic, trace(visit), Optional.empty());
    }

    private List<Moment> trace(Visit visit) {
        List<Moment> moments = new ArrayList<>();
        for (Visit each = visit; each != null; each = each.before()) {
            Letter input = each.letter() == null ? Letter.SILENCE : letter(each.letter());
            moments.add(
                    new Moment(input, sent(each.output()), words(each.configuration()), List.of()));
        }
        Collections.reverse(moments);
        return moments;
    }

    private Letter letter(Value[] messages) {
        return Letter.of(subject.component().inputs(), messages);
    }

    private Map<String, Sent> sent(Output output) {
        Map<String, Sent> sent = new LinkedHashMap<>();
        List<Port> outputs = subject.component().outputs();
        for (int i = 0; i < outputs.size(); i++) {
            sent.put(outputs.get(i).name(), output.ports().get(i));
        }
        return sent;
    }

    /** {@code driving (n = 1) on {frontUS = tooClose}}. */
    final String words(Situation situation) {
        return words(situation.visit().configuration()) + " on " + words(situation.letter());
    }

    /** The state, and the values of the variables. */
    final String words(Configuration configuration) {
        return ConfigurationText.of(subject.automaton(), configuration);
    }

    /** {@code {frontUS = tooClose}}, or {@code silence}. */
    final String words(Value[] letter) {
        List<String> items = new ArrayList<>();
        List<Port> inputs = subject.component().inputs();
        for (int i = 0; i < letter.length; i++) {
            if (letter[i] != null) {
                items.add(inputs.get(i).name() + " = " + letter[i]);
            }
        }
        return listed(items, "silence");
    }

    /** {@code {cmd = stop}}, or {@code nothing}. */
    final String words(Output output) {
        Map<String, Sent> sent = sent(output);
        sent.values().removeIf(Sent.SILENCE::equals);
        List<String> items = new ArrayList<>();
        sent.forEach((port, each) -> items.add(port + " = " + each));
        return listed(items, "nothing");
    }

    private static String listed(List<String> items, String none) {
        return items.isEmpty() ? none : "{" + String.join(", ", items) + "}";
    }
}
