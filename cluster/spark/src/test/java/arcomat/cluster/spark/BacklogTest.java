package arcomat.cluster.spark;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Trial;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.stream.LongStream;

class BacklogTest {
    private static final long MILLISECOND = 1_000_000;

    private static List<Trial> trials(long from, long to) {
        return LongStream.range(from, to).mapToObj(i -> new Trial(i, i, Map.of())).toList();
    }

    /** With so many trials, whose runs take so long. */
    private static Backlog after(int made, long nanoseconds) {
        Backlog backlog = new Backlog();
        backlog.submit(trials(0, made));
        while (!backlog.next(1).isEmpty()) {
            backlog.done(made, made * nanoseconds);
        }
        return backlog;
    }

    @Test
    void eachCoreHasATaskAndOthersThatWait() {
        Backlog backlog = new Backlog();
        backlog.submit(trials(0, 100));
        assertThat(backlog.next(2)).hasSize(6).allSatisfy(task -> assertThat(task).hasSize(4));
        for (int i = 0; i < 3; i++) {
            backlog.done(4, 4 * MILLISECOND);
            assertThat(backlog.next(2)).isEmpty();
        }
        backlog.done(4, 4 * MILLISECOND);
        assertThat(backlog.next(2)).hasSize(4);
    }

    @Test
    void fewTrialsAreSpread() {
        Backlog backlog = new Backlog();
        backlog.submit(trials(0, 5));
        assertThat(backlog.next(4)).extracting(List::size).containsExactly(1, 1, 1, 1, 1);
    }

    @Test
    void tasksAreAsLongAsRunsAreShort() {
        Backlog quick = after(4, MILLISECOND / 1000);
        quick.submit(trials(0, 1000));
        assertThat(quick.next(1).get(0)).hasSize(Backlog.BATCH);
        Backlog usual = after(4, 20 * MILLISECOND);
        usual.submit(trials(0, 1000));
        assertThat(usual.next(1).get(0)).hasSize(25);
        Backlog slow = after(4, 10_000 * MILLISECOND);
        slow.submit(trials(0, 1000));
        assertThat(slow.next(1).get(0)).hasSize(1);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4})
    void nothingIsLostAndNothingComesTwice(long seed) {
        Random random = new Random(seed);
        Backlog backlog = new Backlog();
        Deque<List<Trial>> running = new ArrayDeque<>();
        List<Long> made = new ArrayList<>();
        int submitted = 0;
        while (made.size() < 3000) {
            if (submitted < 3000 && random.nextBoolean()) {
                backlog.submit(trials(submitted, submitted + 100));
                submitted += 100;
            }
            running.addAll(backlog.next(1 + random.nextInt(5))); // cores come and go
            if (!running.isEmpty()) {
                List<Trial> task = running.remove();
                task.forEach(trial -> made.add(trial.number()));
                backlog.done(task.size(), task.size() * MILLISECOND * random.nextInt(50));
            }
        }
        assertThat(made).containsExactlyElementsOf(LongStream.range(0, 3000).boxed().toList());
    }
}
