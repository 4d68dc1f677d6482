package arcomat.analysis.search.encoding;

import arcomat.analysis.search.system.NetworkSystem;
import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.semantics.value.SmallType;

import org.jspecify.annotations.Nullable;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;

/**
 * All that the inputs of a network may bring, tried one by one.
 *
 * @param messages by input what may come, silence among it; a letter has a number of one for each
 */
record AllLetters(List<List<@Nullable Value>> messages) {
    static AllLetters of(NetworkSystem system) {
        return new AllLetters(system.inputs().stream().map(AllLetters::all).toList());
    }

    private static List<@Nullable Value> all(Port port) {
        List<@Nullable Value> all = new ArrayList<>();
        if (!port.total()) {
            all.add(null);
        }
        all.addAll(SmallType.values(port.type()).orElseThrow());
        return all;
    }

    /**
     * @param task told each letter; it is another one afterwards
     */
    void each(Consumer<int[]> task) {
        int[] letter = new int[messages.size()];
        do {
            task.accept(letter);
        } while (next(letter));
    }

    private boolean next(int[] letter) {
        for (int port = 0; port < letter.length; port++) {
            if (++letter[port] < messages.get(port).size()) {
                return true;
            }
            letter[port] = 0;
        }
        return false;
    }

    @Nullable Value[] values(int[] letter) {
        @Nullable Value[] own = new Value[letter.length];
        for (int port = 0; port < letter.length; port++) {
            own[port] = messages.get(port).get(letter[port]);
        }
        return own;
    }
}
