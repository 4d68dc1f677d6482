package arcomat.analysis.automaton;

import arcomat.analysis.search.Moment;
import arcomat.analysis.search.system.ConfigurationText;
import arcomat.analysis.smt.Subject;
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

/** Tells how a situation comes about, in names instead of positions. */
final class Story {
    private final Subject subject;

    Story(Subject subject) {
        this.subject = subject;
    }

    /** A finding that is seen in a situation, on its letter. */
    Finding finding(Diagnostic diagnostic, Situation situation) {
        return new Finding(
                diagnostic, trace(situation.visit()), Optional.of(letter(situation.letter())));
    }

    /** A finding that is seen in a configuration, whatever is read there. */
    Finding finding(Diagnostic diagnostic, Visit visit) {
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

    /** The state, and the values of the variables. */
    String words(Configuration configuration) {
        return ConfigurationText.of(subject.automaton(), configuration);
    }

    /** {@code {frontUS = tooClose}}, or {@code silence}. */
    String words(Value[] letter) {
        List<String> items = new ArrayList<>();
        List<Port> inputs = subject.component().inputs();
        for (int i = 0; i < letter.length; i++) {
            if (letter[i] != null) {
                items.add(inputs.get(i).name() + " = " + letter[i]);
            }
        }
        return items.isEmpty() ? "silence" : "{" + String.join(", ", items) + "}";
    }

    /** {@code {cmd = stop}}, or {@code nothing}. */
    String words(Output output) {
        List<String> items = new ArrayList<>();
        sent(output)
                .forEach(
                        (port, sent) -> {
                            if (!sent.equals(Sent.SILENCE)) {
                                items.add(port + " = " + sent);
                            }
                        });
        return items.isEmpty() ? "nothing" : "{" + String.join(", ", items) + "}";
    }
}
