package arcomat.generate.view;

import java.util.List;

/**
 * A part of a composite, or an array of parts.
 *
 * @param arguments of its constructor
 * @param length of the array; 0 for a single part
 * @param elements how the array is filled; empty for a single part
 */
public record PartView(
        String type,
        String name,
        String arguments,
        String comment,
        int length,
        List<ElementsView> elements) {

    public static PartView single(String type, String name, String arguments, String comment) {
        return new PartView(type, name, arguments, comment, 0, List.of());
    }

    /**
     * Elements of an array that are constructed alike.
     *
     * @param place the element that is assigned to
     * @param index variable of the loop; empty for a single element
     * @param first first value of the index
     * @param end the index stays below
     */
    public record ElementsView(String place, String arguments, String index, int first, int end) {}
}
