package arcomat.analysis.search.packed;

import arcomat.analysis.search.composition.EventUnfolding;
import arcomat.analysis.search.packed.EventLetters.Letter;
import arcomat.analysis.search.packed.EventPart.Delivery;
import arcomat.analysis.search.packed.EventPart.Row;
import arcomat.analysis.search.packed.PackedNetwork.CannotPack;

import com.carrotsearch.hppc.IntArrayList;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;

/**
 * A run to completion as far as it has come: where the parts are, what waits in their queues, and
 * whose turn it is. Where there are several ways to go on, it takes the first one, and later goes
 * back for the others.
 *
 * <p>A run that circles is no matter for tables: it is given up as too long, sooner or later, since
 * the way round the circle can be taken again and again.
 */
final class PackedRun {
    /** Is told what happens on the way. */
    interface Listener {
        /** A part has looked at what comes from outside. */
        void look(int looks);

        /** The run ends in one of the ways that it might go on. */
        void end(int problem);
    }

    /** Several ways to go on. */
    private static final class Choice {
        private final int part;
        private final Row row;
        private int next = 1;

        Choice(int part, Row row) {
            this.part = part;
            this.row = row;
        }
    }

    private final EventNetwork network;
    private final Listener listener;
    private final int[] where;
    private final int[] held;
    private final EventQueue[] queues;
    private int[] outside;
    private int waiting;
    private int turn;
    private int shown;
    private int length;
    private int reactions;
    private final Deque<Choice> choices = new ArrayDeque<>();

    /** The run at each choice, one behind the other. */
    private final IntArrayList saved = new IntArrayList();

    private final IntArrayList starts = new IntArrayList();

    PackedRun(EventNetwork network, Listener listener) {
        this.network = network;
        this.listener = listener;
        int count = network.parts.size();
        where = new int[count];
        held = new int[count];
        outside = new int[count];
        queues = new EventQueue[count];
        for (int part = 0; part < count; part++) {
            queues[part] = new EventQueue(network.parts.get(part).capacity);
        }
    }

    /**
     * Begins with an event; whether the run goes on.
     *
     * @param where configurations of the parts
     * @param held what their registers hold
     */
    boolean begin(int[] where, int[] held, Letter letter) {
        System.arraycopy(where, 0, this.where, 0, where.length);
        System.arraycopy(held, 0, this.held, 0, held.length);
        outside = letter.outside();
        if (waiting > 0) {
            Arrays.stream(queues).forEach(EventQueue::clear);
        }
        waiting = 0;
        turn = 0;
        shown = 0;
        length = 0;
        reactions = 0;
        choices.clear();
        saved.elementsCount = 0;
        starts.elementsCount = 0;
        return deliver(letter.event());
    }

    /** Whether nothing waits any more. */
    boolean isComplete() {
        return waiting == 0;
    }

    int where(int part) {
        return where[part];
    }

    int held(int part) {
        return held[part];
    }

    /** What has been shown, as {@link ShownSequences} has it. */
    int shown() {
        return shown;
    }

    /** The part whose turn it is takes its next event; whether the run goes on. */
    boolean react() {
        if (length > EventUnfolding.LONGEST || reactions > EventUnfolding.MOST_REACTIONS) {
            throw new CannotPack("one event causes too much");
        }
        int part = turn;
        while (queues[part].isEmpty()) {
            part = after(part);
        }
        Row row = network.row(part, where[part], queues[part].first(), held[part], outside[part]);
        reactions++;
        if (row.look() >= 0) {
            listener.look(row.look());
        }
        for (int problem : row.problems()) {
            listener.end(problem);
        }
        int ways = row.next().length;
        if (ways > 1) {
            choices.push(new Choice(part, row));
            save();
        }
        return ways > 0 && follow(part, row, 0);
    }

    private int after(int part) {
        return part + 1 == queues.length ? 0 : part + 1;
    }

    /** Goes back to the latest choice that has another way; whether there is one. */
    boolean goBack() {
        while (!choices.isEmpty()) {
            Choice choice = choices.peek();
            restore();
            int way = choice.next++;
            if (choice.next == choice.row.next().length) {
                choices.pop();
                saved.elementsCount = starts.get(starts.size() - 1);
                starts.elementsCount--;
            }
            if (follow(choice.part, choice.row, way)) {
                return true;
            }
        }
        return false;
    }

    private boolean follow(int part, Row row, int way) {
        queues[part].remove();
        waiting--;
        turn = after(part);
        length++;
        where[part] = row.next()[way];
        for (Delivery each : row.sent()[way]) {
            if (!deliver(each)) {
                return false;
            }
        }
        return true;
    }

    /** Whether there is room for it. */
    private boolean deliver(Delivery message) {
        if (message.shown() >= 0) {
            shown = network.deliveries.shown.then(shown, message.shown());
        }
        int[] latches = message.latches();
        for (int i = 0; i < latches.length; i += 3) {
            HeldMessages registers = network.parts.get(latches[i]).registers;
            held[latches[i]] = registers.after(held[latches[i]], latches[i + 1], latches[i + 2]);
        }
        int[] events = message.events();
        for (int i = 0; i < events.length; i += 2) {
            if (queues[events[i]].isFull()) {
                listener.end(network.noRoom(events[i], events[i + 1]));
                return false;
            }
            queues[events[i]].add(events[i + 1]);
            waiting++;
        }
        return true;
    }

    private void save() {
        starts.add(saved.size());
        saved.add(shown, length, waiting);
        saved.add(where, 0, where.length);
        saved.add(held, 0, held.length);
        for (EventQueue queue : queues) {
            queue.save(saved);
        }
    }

    private void restore() {
        int[] from = saved.buffer;
        int position = starts.get(starts.size() - 1);
        shown = from[position++];
        length = from[position++];
        waiting = from[position++];
        System.arraycopy(from, position, where, 0, where.length);
        position += where.length;
        System.arraycopy(from, position, held, 0, held.length);
        position += held.length;
        for (EventQueue queue : queues) {
            position = queue.restore(from, position);
        }
    }
}
