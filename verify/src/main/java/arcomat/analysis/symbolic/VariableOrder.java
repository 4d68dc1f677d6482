package arcomat.analysis.symbolic;

import java.util.Arrays;

/**
 * Which variable a solver decides about next: that which was in most of the recent conflicts
 * (VSIDS: Moskewicz, Madigan, Zhao, Zhang, Malik, "Chaff: engineering an efficient SAT solver", DAC
 * 2001), kept in a binary heap.
 */
final class VariableOrder {
    private static final double DECAY = 1 / 0.95;
    private static final double MOST = 1e100;

    private double[] activity = new double[64];
    private int[] heap = new int[64];

    /** Per variable its place in the heap, -1 where it is not there. */
    private int[] places = new int[64];

    private int size;
    private double step = 1;

    VariableOrder() {
        Arrays.fill(places, -1);
    }

    void add(int variable) {
        if (variable >= places.length) {
            int old = places.length;
            activity = Arrays.copyOf(activity, 2 * variable);
            places = Arrays.copyOf(places, 2 * variable);
            heap = Arrays.copyOf(heap, 2 * variable);
            Arrays.fill(places, old, places.length, -1);
        }
        insert(variable);
    }

    /** Puts one back that has been taken. */
    void insert(int variable) {
        if (places[variable] < 0) {
            places[variable] = size;
            heap[size++] = variable;
            up(places[variable]);
        }
    }

    boolean isEmpty() {
        return size == 0;
    }

    /** Takes the most active one. */
    int take() {
        int top = heap[0];
        places[top] = -1;
        int last = heap[--size];
        if (size > 0) {
            heap[0] = last;
            places[last] = 0;
            down(0);
        }
        return top;
    }

    /** It was in a conflict. */
    void bump(int variable) {
        activity[variable] += step;
        if (activity[variable] > MOST) {
            for (int i = 0; i < activity.length; i++) {
                activity[i] /= MOST;
            }
            step /= MOST;
        }
        if (places[variable] >= 0) {
            up(places[variable]);
        }
    }

    /** What was long ago counts less. */
    void decay() {
        step *= DECAY;
    }

    private void up(int from) {
        int place = from;
        int variable = heap[place];
        while (place > 0 && activity[heap[(place - 1) / 2]] < activity[variable]) {
            move(heap[(place - 1) / 2], place);
            place = (place - 1) / 2;
        }
        move(variable, place);
    }

    private void down(int from) {
        int place = from;
        int variable = heap[place];
        while (2 * place + 1 < size) {
            int child = 2 * place + 1;
            if (child + 1 < size && activity[heap[child + 1]] > activity[heap[child]]) {
                child++;
            }
            if (activity[heap[child]] <= activity[variable]) {
                break;
            }
            move(heap[child], place);
            place = child;
        }
        move(variable, place);
    }

    private void move(int variable, int place) {
        heap[place] = variable;
        places[variable] = place;
    }
}
