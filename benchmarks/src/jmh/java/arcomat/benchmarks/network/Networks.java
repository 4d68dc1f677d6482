package arcomat.benchmarks.network;

/** The contestants by name. */
final class Networks {
    private Networks() {}

    static Network of(String contestant, Shape shape) {
        return switch (contestant) {
            case "generated" -> GeneratedNetwork.of(shape, false);
            case "shuffled" -> GeneratedNetwork.of(shape, true);
            case "objects" -> new ObjectNetwork(shape);
            case "arrays" -> new ArrayNetwork(shape);
            default -> throw new IllegalArgumentException(contestant);
        };
    }
}
