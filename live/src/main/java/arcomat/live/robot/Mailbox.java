package arcomat.live.robot;

import java.util.ArrayDeque;
import java.util.Deque;

/** Numbers that wait. It holds a few; where more come, the oldest are lost. */
final class Mailbox {
    private static final int CAPACITY = 8;

    private final Deque<Integer> messages = new ArrayDeque<>();

    void put(int message) {
        if (messages.size() == CAPACITY) {
            messages.remove();
        }
        messages.add(message);
    }

    boolean isEmpty() {
        return messages.isEmpty();
    }

    int take() {
        return messages.remove();
    }
}
