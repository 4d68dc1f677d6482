package arcomat.analysis.game.controller;

import arcomat.analysis.search.IntKey;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Divides a table over several ports into few boxes with one content each: kinds of messages that
 * make no difference are put together, ports that make none are left out.
 */
final class BoxCover {
    /**
     * A box of the table.
     *
     * @param groups per port the positions of its samples; null where the port makes no difference
     */
    record Box(int[][] groups, int content) {}

    /** Up to so many ports every order of division is tried. */
    private static final int FEW_PORTS = 3;

    private final int[] sizes;

    private BoxCover(int[] sizes) {
        this.sizes = sizes;
    }

    /**
     * @param sizes per port the number of its samples
     * @param cells one content per combination; those of the last port change fastest
     */
    static List<Box> of(int[] sizes, int[] cells) {
        int[][] open = new int[sizes.length][];
        return new BoxCover(sizes).divide(cells, open, new boolean[sizes.length]);
    }

    /**
     * @param groups what is fixed so far
     * @param done ports that the cells no longer have a place for
     */
    private List<Box> divide(int[] cells, int[][] groups, boolean[] done) {
        boolean[] settled = done.clone();
        int[] rest = leaveOut(cells, settled);
        List<Integer> open = new ArrayList<>();
        for (int port = 0; port < sizes.length; port++) {
            if (!settled[port]) {
                open.add(port);
            }
        }
        if (open.isEmpty()) {
            return List.of(new Box(groups, rest[0]));
        }
        if (open.size() > FEW_PORTS) {
            int[] last = rest;
            open.sort(Comparator.comparingInt(port -> parts(last, port, settled).size()));
            open.subList(1, open.size()).clear();
        }
        List<Box> best = divideBy(open.get(0), rest, groups, settled);
        for (int port : open.subList(1, open.size())) {
            List<Box> boxes = divideBy(port, rest, groups, settled);
            best = boxes.size() < best.size() ? boxes : best;
        }
        return best;
    }

    /** Settles the ports that make no difference. */
    private int[] leaveOut(int[] cells, boolean[] settled) {
        int[] rest = cells;
        boolean again = true;
        while (again) {
            again = false;
            for (int port = 0; port < sizes.length; port++) {
                if (!settled[port]) {
                    Map<IntKey, List<Integer>> parts = parts(rest, port, settled);
                    if (parts.size() == 1) {
                        rest = parts.keySet().iterator().next().all();
                        settled[port] = true;
                        again = true;
                    }
                }
            }
        }
        return rest;
    }

    private List<Box> divideBy(int port, int[] cells, int[][] groups, boolean[] settled) {
        boolean[] done = settled.clone();
        done[port] = true;
        List<Box> boxes = new ArrayList<>();
        parts(cells, port, settled)
                .forEach(
                        (content, samples) -> {
                            int[][] longer = groups.clone();
                            longer[port] = samples.stream().mapToInt(Integer::intValue).toArray();
                            boxes.addAll(divide(content.all(), longer, done));
                        });
        return boxes;
    }

    /** The samples of a port by what is in the table for them. */
    private Map<IntKey, List<Integer>> parts(int[] cells, int port, boolean[] done) {
        int inner = 1;
        for (int later = port + 1; later < sizes.length; later++) {
            inner *= done[later] ? 1 : sizes[later];
        }
        int size = sizes[port];
        Map<IntKey, List<Integer>> parts = new LinkedHashMap<>();
        for (int sample = 0; sample < size; sample++) {
            int[] part = new int[cells.length / size];
            for (int i = 0; i < part.length; i++) {
                part[i] = cells[i / inner * inner * size + sample * inner + i % inner];
            }
            parts.computeIfAbsent(new IntKey(part), each -> new ArrayList<>()).add(sample);
        }
        return parts;
    }
}
