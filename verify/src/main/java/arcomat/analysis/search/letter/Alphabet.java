package arcomat.analysis.search.letter;

import arcomat.analysis.smt.MessageExamples;
import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.InputAbstraction;
import arcomat.semantics.value.InputAbstraction.PortAbstraction;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/**
 * One letter of each kind that some classes together tell apart: few messages first, then in the
 * order in which ports and values are declared. Ports that nobody looks at stay silent.
 */
public final class Alphabet {
    private final List<Value[]> letters;
    private final Optional<String> missing;
    private final int[] messages;
    private final long[][] kinds;

    /**
     * @param profile a letter is a slice or an event
     * @param inputs of the letters
     * @param classes each with the positions of its ports in a letter
     * @param positions one array per element of {@code classes}
     */
    public Alphabet(
            Component.Profile profile,
            List<Port> inputs,
            List<LetterClasses> classes,
            List<int[]> positions) {
        this(profile, inputs, classes, positions, Representatives.NONE);
    }

    /**
     * @param representatives for data of which it only matters which are the same
     */
    public Alphabet(
            Component.Profile profile,
            List<Port> inputs,
            List<LetterClasses> classes,
            List<int[]> positions,
            Representatives representatives) {
        this(profile, inputs, classes, positions, representatives, Optional.empty());
    }

    /**
     * @param examples of messages that are calculated with; empty where there are none to be had
     */
    public Alphabet(
            Component.Profile profile,
            List<Port> inputs,
            List<LetterClasses> classes,
            List<int[]> positions,
            Representatives representatives,
            Optional<MessageExamples.Source> examples) {
        PortAbstraction[] looks = new PortAbstraction[inputs.size()];
        Arrays.fill(looks, new InputAbstraction.Unseen());
        for (int c = 0; c < classes.size(); c++) {
            List<PortAbstraction> own = classes.get(c).abstraction().looks();
            for (int i = 0; i < own.size(); i++) {
                int position = positions.get(c)[i];
                looks[position] = looks[position].and(own.get(i));
            }
        }
        MessageExamples.Rows found =
                new CalculatedPorts(inputs, List.of(looks), representatives)
                        .letters(profile, examples);
        letters = found.rows();
        missing = found.missing();
        messages = letters.stream().mapToInt(Letters::messages).toArray();
        kinds = new long[classes.size()][letters.size()];
        for (int c = 0; c < classes.size(); c++) {
            for (int i = 0; i < messages.length; i++) {
                kinds[c][i] = classes.get(c).kind(letters.get(i), positions.get(c));
            }
        }
    }

    public int size() {
        return messages.length;
    }

    /**
     * Why there may be letters that are told apart from all of these; empty where there are none.
     */
    public Optional<String> missing() {
        return missing;
    }

    /** Messages by position of the port, null for silence; not to be written to. */
    public Value[] letter(int index) {
        return letters.get(index);
    }

    public int messages(int index) {
        return messages[index];
    }

    /** The number of a letter by one of the partitions into classes. */
    public long kind(int which, int index) {
        return kinds[which][index];
    }
}
