package arcomat.cluster.hazelcast;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Trial;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.UUID;
import java.util.stream.LongStream;

class DispatchTest {
    private static final int TRIALS = 2000;

    private static List<Trial> trials(long from, long to) {
        return LongStream.range(from, to).mapToObj(i -> new Trial(i, i, Map.of())).toList();
    }

    private static List<Long> numbers(List<Dispatch.Batch> batches) {
        return batches.stream()
                .flatMap(batch -> batch.trials().stream())
                .map(Trial::number)
                .sorted()
                .toList();
    }

    @Test
    void withoutWorkersEverythingWaits() {
        Dispatch dispatch = new Dispatch();
        dispatch.submit(trials(0, 5));
        assertThat(dispatch.assign()).isEmpty();
        dispatch.join(UUID.randomUUID(), 2);
        assertThat(numbers(dispatch.assign())).containsExactly(0L, 1L, 2L, 3L, 4L);
        assertThat(dispatch.assign()).isEmpty();
    }

    @Test
    void aWorkerGetsAsItHasThreads() {
        Dispatch dispatch = new Dispatch();
        UUID small = UUID.randomUUID();
        UUID large = UUID.randomUUID();
        dispatch.join(small, 1);
        dispatch.join(large, 3);
        dispatch.submit(trials(0, 40));
        Map<UUID, Integer> given = new HashMap<>();
        dispatch.assign()
                .forEach(batch -> given.merge(batch.worker(), batch.trials().size(), Integer::sum));
        assertThat(given).containsEntry(small, 10).containsEntry(large, 30);
    }

    @Test
    void whatADeadWorkerHeldIsGivenToOthersFirst() {
        Dispatch dispatch = new Dispatch();
        UUID dead = UUID.randomUUID();
        dispatch.join(dead, 1);
        dispatch.submit(trials(0, 4));
        dispatch.assign();
        assertThat(dispatch.answer(dead, 1)).isPresent();
        dispatch.submit(trials(4, 6));
        assertThat(dispatch.leave(dead)).isEqualTo(3);
        assertThat(dispatch.leave(dead)).isZero();
        dispatch.join(UUID.randomUUID(), 1);
        assertThat(dispatch.assign())
                .flatExtracting(Dispatch.Batch::trials)
                .extracting(Trial::number)
                .containsExactly(0L, 2L, 3L, 4L, 5L);
    }

    /** A worker that was thought dead, as when its machine slept, and goes on. */
    @Test
    void theFirstAnswerCountsAndNoOther() {
        Dispatch dispatch = new Dispatch();
        UUID slow = UUID.randomUUID();
        UUID other = UUID.randomUUID();
        dispatch.join(slow, 1);
        dispatch.submit(trials(0, 2));
        dispatch.assign();
        dispatch.leave(slow);
        assertThat(dispatch.answer(slow, 0)).isPresent();
        dispatch.join(other, 1);
        assertThat(numbers(dispatch.assign())).containsExactly(1L);
        assertThat(dispatch.answer(slow, 1)).isPresent();
        assertThat(dispatch.answer(other, 1)).isEmpty();
        assertThat(dispatch.answer(other, 7)).as("nobody asked").isEmpty();
    }

    /** Workers come, answer in any order, and die at any moment. */
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8})
    void nothingIsLostAndNothingComesTwice(long seed) {
        Random random = new Random(seed);
        Dispatch dispatch = new Dispatch();
        Map<UUID, List<Trial>> held = new HashMap<>();
        List<Long> answered = new ArrayList<>();
        dispatch.submit(trials(0, TRIALS));
        while (answered.size() < TRIALS) {
            if (held.size() < 2 || random.nextInt(50) == 0) {
                UUID fresh = new UUID(random.nextLong(), random.nextLong());
                held.put(fresh, new ArrayList<>());
                dispatch.join(fresh, 1 + random.nextInt(4));
            }
            dispatch.assign().forEach(batch -> held.get(batch.worker()).addAll(batch.trials()));
            UUID one = List.copyOf(held.keySet()).get(random.nextInt(held.size()));
            if (random.nextInt(30) == 0) {
                dispatch.leave(one);
                held.remove(one);
            } else if (!held.get(one).isEmpty()) {
                List<Trial> mine = held.get(one);
                Trial trial = mine.remove(random.nextInt(mine.size()));
                dispatch.answer(one, trial.number()).ifPresent(each -> answered.add(each.number()));
            }
        }
        assertThat(answered).doesNotHaveDuplicates().hasSize(TRIALS);
    }
}
