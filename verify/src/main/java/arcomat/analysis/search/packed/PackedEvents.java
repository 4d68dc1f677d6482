package arcomat.analysis.search.packed;

import arcomat.analysis.search.packed.EventLetters.Letter;
import arcomat.analysis.search.packed.PackedNetwork.TooNarrow;
import arcomat.semantics.expression.Sent;

import java.util.Arrays;

/**
 * Runs to completion in numbers: all that one event may cause, first alternatives first. What a
 * configuration looks at is known when it has looked, so letters are run to find that out; each is
 * run once.
 */
final class PackedEvents implements PackedSteps, PackedRun.Listener {
    /** In place of what is shown. */
    private static final long ENDED = -1;

    private final EventNetwork network;
    private final PackedLayout layout;
    private final PackedRun run;

    /** Of a configuration, and one more of what is shown. */
    private final int words;

    /** The configuration that was taken: as it is, and number by number. */
    private final long[] configuration;

    private final int[] where;
    private final int[] held;
    private int drivenBefore;
    private int drivenAfter;
    private long taken;

    /** By letter, when it was run, and where what came of it begins and ends. */
    private long[] runAt = new long[16];

    private int[] begins = new int[16];
    private int[] ends = new int[16];
    private long[] outcomes;
    private int size;
    private int position;
    private int end;
    private int looks;

    /**
     * @param layout that of the network
     */
    PackedEvents(EventNetwork network, PackedLayout layout) {
        this.network = network;
        this.layout = layout;
        words = layout.words() + 1;
        configuration = new long[layout.words()];
        where = new int[network.parts.size()];
        held = new int[network.parts.size()];
        outcomes = new long[16 * words];
        run = new PackedRun(network, this);
    }

    @Override
    public void begin(long[] from) {
        System.arraycopy(from, 0, configuration, 0, configuration.length);
        for (int part = 0; part < where.length; part++) {
            where[part] = layout.get(from, 2 * part);
            held[part] = layout.get(from, 2 * part + 1);
        }
        drivenBefore = layout.get(from, network.heldField);
        taken++;
        size = 0;
    }

    /** As {@link arcomat.analysis.search.composition.EventUnfolding#abstraction}. */
    @Override
    public long looks() {
        looks = network.firstLooks;
        int before;
        do {
            before = looks;
            for (int letter : network.letters(before)) {
                run(letter);
            }
        } while (looks != before);
        return looks;
    }

    @Override
    public void look(int more) {
        looks = network.looks.join(looks, more);
    }

    private void run(int letter) {
        if (letter >= runAt.length) {
            int length = Math.max(letter + 1, 2 * runAt.length);
            runAt = Arrays.copyOf(runAt, length);
            begins = Arrays.copyOf(begins, length);
            ends = Arrays.copyOf(ends, length);
        }
        if (runAt[letter] == taken) {
            return;
        }
        begins[letter] = size;
        Letter event = network.letters.get(letter);
        drivenAfter = event.held();
        boolean goesOn = run.begin(where, held, event);
        while (goesOn) {
            if (run.isComplete()) {
                complete();
                goesOn = run.goBack();
            } else {
                goesOn = run.react() || run.goBack();
            }
        }
        ends[letter] = size;
        runAt[letter] = taken;
    }

    private void complete() {
        reserve();
        System.arraycopy(configuration, 0, outcomes, size, words - 1);
        for (int part = 0; part < where.length; part++) {
            change(2 * part, where[part], run.where(part));
            change(2 * part + 1, held[part], run.held(part));
        }
        change(network.heldField, drivenBefore, drivenAfter);
        outcomes[size + words - 1] = run.shown();
        size += words;
    }

    private void change(int field, int before, int after) {
        if (before == after) {
            return;
        }
        if (!layout.fits(field, after)) {
            throw new TooNarrow();
        }
        long changed = (long) (before ^ after) << layout.shift(field);
        outcomes[size + layout.word(field)] ^= changed;
    }

    @Override
    public void end(int problem) {
        reserve();
        Arrays.fill(outcomes, size, size + words - 1, 0);
        change(network.problemField, 0, problem);
        change(network.heldField, 0, drivenAfter);
        outcomes[size + words - 1] = ENDED;
        size += words;
    }

    private void reserve() {
        if (size + words > outcomes.length) {
            outcomes = Arrays.copyOf(outcomes, 2 * outcomes.length);
        }
    }

    /** A letter that cannot follow leads nowhere. */
    @Override
    public void read(int[] letter) {
        int number = letter[0];
        if ((drivenBefore & ~network.letters.get(number).held()) != 0) {
            position = 0;
            end = 0;
            return;
        }
        run(number);
        position = begins[number] - words;
        end = ends[number];
    }

    @Override
    public boolean next() {
        position += words;
        return position < end;
    }

    @Override
    public boolean hasEnded() {
        return shown() == ENDED;
    }

    @Override
    public void after(long[] into) {
        System.arraycopy(outcomes, position, into, 0, words - 1);
    }

    @Override
    public long shown() {
        return outcomes[position + words - 1];
    }

    @Override
    public Sent shown(long number, int signal) {
        return network.deliveries.shown((int) number, signal);
    }
}
