package arcomat.analysis.game;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Divides a table over several ports into few boxes with one content each: kinds of messages that
 * make no difference are put together, ports that make none are left out.
 */
final class Cover {
    /**
     * A box of the table.
     *
     * @param groups per port the positions of its samples; null where the port makes no difference
     */
    record Box(int[][] groups, int content) {}

    private record Content(int[] cells) {
        @Override
        public boolean equals(Object other) {
            return other instanceof Content content && Arrays.equals(cells, content.cells);
        }

        @Override
        public int hashCode() {
            return Arrays.hashCode(cells);
        }
    }

    private final int[] sizes;
    private final List<Box> boxes = new ArrayList<>();

    private Cover(int[] sizes) {
        this.sizes = sizes;
    }

    /**
     * @param sizes per port the number of its samples
     * @param cells one content per combination; those of the last port change fastest
     */
    static List<Box> of(int[] sizes, int[] cells) {
        Cover cover = new Cover(sizes);
        cover.divide(cells, new int[sizes.length][], new boolean[sizes.length]);
        return cover.boxes;
    }

    /**
     * @param groups what is fixed so far
     * @param done ports that the cells no longer have a place for
     */
    private void divide(int[] cells, int[][] groups, boolean[] done) {
        int best = -1;
        Map<Content, List<Integer>> division = null;
        boolean[] settled = done.clone();
        int[] rest = cells;
        for (int port = 0; port < sizes.length; port++) {
            if (settled[port]) {
                continue;
            }
            Map<Content, List<Integer>> parts = divide(rest, port, settled);
            if (parts.size() == 1) {
                rest = parts.keySet().iterator().next().cells;
                settled[port] = true;
                best = -1;
                division = null;
                port = -1;
            } else if (division == null || parts.size() < division.size()) {
                best = port;
                division = parts;
            }
        }
        if (best < 0) {
            boxes.add(new Box(groups, rest[0]));
            return;
        }
        settled[best] = true;
        for (Map.Entry<Content, List<Integer>> part : division.entrySet()) {
            int[][] longer = groups.clone();
            longer[best] = part.getValue().stream().mapToInt(Integer::intValue).toArray();
            divide(part.getKey().cells, longer, settled);
        }
    }

    /** The samples of a port by what is in the table for them. */
    private Map<Content, List<Integer>> divide(int[] cells, int port, boolean[] done) {
        int inner = 1;
        for (int later = port + 1; later < sizes.length; later++) {
            inner *= done[later] ? 1 : sizes[later];
        }
        int size = sizes[port];
        Map<Content, List<Integer>> parts = new LinkedHashMap<>();
        for (int sample = 0; sample < size; sample++) {
            int[] part = new int[cells.length / size];
            for (int i = 0; i < part.length; i++) {
                part[i] = cells[i / inner * inner * size + sample * inner + i % inner];
            }
            parts.computeIfAbsent(new Content(part), each -> new ArrayList<>()).add(sample);
        }
        return parts;
    }
}
