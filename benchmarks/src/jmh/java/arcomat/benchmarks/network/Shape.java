package arcomat.benchmarks.network;

/**
 * @param chains how many there are, all fed with the same input
 * @param length parts of each
 */
record Shape(int chains, int length) {
    /** {@code 100x10} is a hundred chains of ten parts. */
    static Shape parse(String text) {
        String[] numbers = text.split("x");
        return new Shape(Integer.parseInt(numbers[0]), Integer.parseInt(numbers[1]));
    }

    int parts() {
        return chains * length;
    }
}
