package arcomat.campaign.statistics;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.random.RandomGenerator;

/**
 * A walk from 1 that ends at 0 or at the goal, up or down by one: what comes of it is known
 * (Feller, An Introduction to Probability Theory, volume 1, section XIV.2). Luck is drawn once, at
 * the beginning, with equal chances: where there are several, what a walker does after a level
 * depends on who it is.
 *
 * @param luck probabilities of a step up, below a half
 */
record RuinedGambler(List<Double> luck, int goal) {
    private record Walker(double up, int founder) {}

    double probability() {
        return luck.stream()
                .mapToDouble(up -> (1 - up) / up)
                .map(odds -> (odds - 1) / (Math.pow(odds, goal) - 1))
                .average()
                .orElseThrow();
    }

    /** Whether the goal is reached, at once. */
    boolean wins(RandomGenerator random) {
        return climbs(draw(random, 0), 1, goal, random);
    }

    private Walker draw(RandomGenerator random, int founder) {
        return new Walker(luck.get(random.nextInt(luck.size())), founder);
    }

    private static boolean climbs(Walker walker, int from, int to, RandomGenerator random) {
        int place = from;
        while (place > 0 && place < to) {
            place += random.nextDouble() < walker.up() ? 1 : -1;
        }
        return place == to;
    }

    /** A splitting at every second place, with so many trials for each level. */
    Outcome split(int effort, RandomGenerator random) {
        List<Walker> starting = new ArrayList<>();
        for (int i = 0; i < effort; i++) {
            starting.add(draw(random, i));
        }
        List<Splitting.Level> levels = new ArrayList<>();
        for (int from = 1; ; from += 2) {
            int start = from;
            int end = Math.min(goal, from + 2);
            List<Walker> reached =
                    starting.stream().filter(each -> climbs(each, start, end, random)).toList();
            levels.add(new Splitting.Level(effort, reached.size()));
            if (end == goal || reached.isEmpty()) {
                return new Outcome(new Splitting(levels), families(effort, reached));
            }
            starting.clear();
            for (int i = 0; i < effort; i++) {
                starting.add(reached.get(random.nextInt(reached.size())));
            }
        }
    }

    private static Families families(int effort, List<Walker> reached) {
        Long[] sizes = new Long[effort];
        Arrays.fill(sizes, 0L);
        reached.forEach(each -> sizes[each.founder()]++);
        return new Families(List.of(sizes));
    }

    /** What a splitting gave. */
    record Outcome(Splitting splitting, Families families) {
        /** Of an estimate of zero it is zero. */
        double variance() {
            return families.members() == 0 ? 0 : splitting.variance(families);
        }
    }
}
