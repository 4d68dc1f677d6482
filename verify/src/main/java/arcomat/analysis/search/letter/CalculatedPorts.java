package arcomat.analysis.search.letter;

import arcomat.analysis.smt.MessageExamples;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.expression.PartialEvaluation;
import arcomat.semantics.value.InputAbstraction.Compared;
import arcomat.semantics.value.InputAbstraction.Copied;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;
import arcomat.semantics.value.InputAbstraction.Whole;
import arcomat.semantics.value.SmallType;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/**
 * Letters where messages of some ports are calculated with, or compared with each other, that have
 * too many values to try. First it is decided what the other ports carry, and which of these carry
 * something; then come examples for each way in which steps differ.
 *
 * @param looks one per input port
 * @param representatives for data of which it only matters which are the same
 */
record CalculatedPorts(
        List<Port> inputs, List<PortAbstraction> looks, Representatives representatives) {

    /** Letters of an alphabet; why there should be others, if so. */
    MessageExamples.Rows letters(
            Component.Profile profile, Optional<MessageExamples.Source> examples) {
        List<Integer> calculated = new ArrayList<>();
        List<PortAbstraction> others = new ArrayList<>(looks);
        for (int port = 0; port < inputs.size(); port++) {
            if (isCalculated(port)) {
                calculated.add(port);
                others.set(port, new Compared(List.of(), false));
            }
        }
        if (calculated.isEmpty() || examples.isEmpty()) {
            return new MessageExamples.Rows(
                    representatives.letters(profile, inputs, looks), Optional.empty());
        }
        List<Value[]> letters = new ArrayList<>();
        Optional<String> missing = Optional.empty();
        for (Value[] letter : representatives.letters(profile, inputs, others)) {
            Optional<String> why = addTo(letters, letter, calculated, examples.get());
            missing = missing.or(() -> why);
        }
        return new MessageExamples.Rows(letters, missing);
    }

    private boolean isCalculated(int port) {
        PortAbstraction look = looks.get(port);
        return SmallType.values(inputs.get(port).type()).isEmpty()
                && (look instanceof Whole
                        || look instanceof Copied && !representatives.isFree(port));
    }

    private Optional<String> addTo(
            List<Value[]> letters,
            Value[] letter,
            List<Integer> calculated,
            MessageExamples.Source examples) {
        List<Integer> open = calculated.stream().filter(port -> letter[port] != null).toList();
        if (open.isEmpty()) {
            letters.add(letter);
            return Optional.empty();
        }
        List<Port> ports = open.stream().map(inputs::get).toList();
        MessageExamples.Rows found = examples.of(known(letter, open), ports);
        for (Value[] row : found.rows()) {
            Value[] copy = letter.clone();
            for (int i = 0; i < row.length; i++) {
                copy[open.get(i)] = row[i];
            }
            letters.add(copy);
        }
        return found.missing();
    }

    private PartialEvaluation known(Value[] letter, List<Integer> open) {
        Map<String, Value> known = new HashMap<>();
        HashSet<String> names = new HashSet<>();
        for (int port = 0; port < letter.length; port++) {
            Port input = inputs.get(port);
            if (open.contains(port)) {
                names.add(input.name());
            } else if (letter[port] != null) {
                known.put(input.name(), letter[port]);
            } else {
                input.first().ifPresent(held -> known.put(input.name(), held));
            }
        }
        return new PartialEvaluation(known, names);
    }
}
