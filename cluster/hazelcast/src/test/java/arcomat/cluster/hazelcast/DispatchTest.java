package arcomat.cluster.hazelcast;

import static org.assertj.core.api.Assertions.assertThat;

import arcomat.campaign.Trial;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
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
        assertThat(dispatch.leave(dead).again()).isEqualTo(3);
        assertThat(dispatch.leave(dead).again()).isZero();
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

    /**
     * Each worker makes what it has from the first to the last, and is ended by one of them: no end
     * of workers goes there, and whatever was beside it is made.
     */
    @ParameterizedTest
    @CsvSource({"1, 40, 7", "4, 40, 7", "4, 200, 0", "4, 200, 199"})
    void aRunThatEndsItsWorkersIsGivenUpAndNoOther(int threads, long count, long deadly) {
        Dispatch dispatch = new Dispatch();
        dispatch.submit(trials(0, count));
        List<Long> answered = new ArrayList<>();
        List<Trial> givenUp = new ArrayList<>();
        int workers = 0;
        while (answered.size() + givenUp.size() < count) {
            assertThat(++workers).isLessThanOrEqualTo(Dispatch.LOSSES + 1);
            UUID worker = UUID.randomUUID();
            dispatch.join(worker, threads);
            givenUp.addAll(workUntilTheEnd(dispatch, worker, deadly, answered));
        }
        assertThat(givenUp).extracting(Trial::number).containsExactly(deadly);
        assertThat(answered).doesNotHaveDuplicates().hasSize((int) count - 1);
    }

    /** The runs that are given up because this worker is gone. */
    private static List<Trial> workUntilTheEnd(
            Dispatch dispatch, UUID worker, long deadly, List<Long> answered) {
        List<Dispatch.Batch> batches = dispatch.assign();
        while (!batches.isEmpty()) {
            for (Trial each : batches.stream().flatMap(b -> b.trials().stream()).toList()) {
                if (each.number() == deadly) {
                    return dispatch.leave(worker).givenUp();
                }
                dispatch.answer(worker, each.number());
                answered.add(each.number());
            }
            batches = dispatch.assign();
        }
        return List.of();
    }

    /** Two workers that were ended by somebody else take nothing away. */
    @Test
    void whoIsSuspectedIsAloneAndThenLikeOthers() {
        Dispatch dispatch = new Dispatch();
        dispatch.submit(trials(0, 3));
        for (int gone = 1; gone < Dispatch.LOSSES; gone++) {
            UUID dead = UUID.randomUUID();
            dispatch.join(dead, 2);
            assertThat(numbers(dispatch.assign())).containsExactly(0L, 1L, 2L);
            assertThat(dispatch.leave(dead).again()).isEqualTo(3);
        }
        dispatch.submit(trials(3, 6));
        UUID last = UUID.randomUUID();
        dispatch.join(last, 2);
        for (long suspect = 0; suspect < 3; suspect++) {
            assertThat(numbers(dispatch.assign())).containsExactly(suspect);
            assertThat(dispatch.assign()).isEmpty();
            assertThat(dispatch.answer(last, suspect)).isPresent();
        }
        assertThat(numbers(dispatch.assign())).containsExactly(3L, 4L, 5L);
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
                dispatch.leave(one).givenUp().forEach(each -> answered.add(each.number()));
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
