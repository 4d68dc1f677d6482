package arcomat.analysis.search.letter;

import arcomat.model.Component;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.Attention;
import arcomat.semantics.value.Attention.Look;

import java.util.Arrays;
import java.util.List;

/**
 * One letter of each kind that some foci together tell apart: few messages first, then in the order
 * in which ports and values are declared. Ports that nobody looks at stay silent.
 */
public final class Alphabet {
    private final List<Value[]> letters;
    private final int[] messages;
    private final long[][] kinds;

    /**
     * @param profile a letter is a slice or an event
     * @param inputs of the letters
     * @param foci each with the positions of its ports in a letter
     * @param positions one array per focus
     */
    public Alphabet(
            Component.Profile profile,
            List<Port> inputs,
            List<LetterClasses> foci,
            List<int[]> positions) {
        this(profile, inputs, foci, positions, Representatives.NONE);
    }

    /**
     * @param standIns for data of which it only matters which are the same
     */
    public Alphabet(
            Component.Profile profile,
            List<Port> inputs,
            List<LetterClasses> foci,
            List<int[]> positions,
            Representatives standIns) {
        Look[] looks = new Look[inputs.size()];
        Arrays.fill(looks, new Attention.Unseen());
        for (int f = 0; f < foci.size(); f++) {
            List<Look> own = foci.get(f).attention().looks();
            for (int i = 0; i < own.size(); i++) {
                int position = positions.get(f)[i];
                looks[position] = looks[position].and(own.get(i));
            }
        }
        letters = standIns.letters(profile, inputs, List.of(looks));
        messages = letters.stream().mapToInt(Letters::messages).toArray();
        kinds = new long[foci.size()][letters.size()];
        for (int f = 0; f < foci.size(); f++) {
            for (int i = 0; i < messages.length; i++) {
                kinds[f][i] = foci.get(f).kind(letters.get(i), positions.get(f));
            }
        }
    }

    public int size() {
        return messages.length;
    }

    /** Messages by position of the port, null for silence; not to be written to. */
    public Value[] letter(int index) {
        return letters.get(index);
    }

    public int messages(int index) {
        return messages[index];
    }

    /** The number of a letter for one of the foci. */
    public long kind(int focus, int index) {
        return kinds[focus][index];
    }
}
