package arcomat.world.contact;

/** The dry friction of a thing on the floor: it holds what stands, and slows what slides. */
final class Drag {
    private final Sliding body;
    private final double most;
    private double x;
    private double y;

    /**
     * @param most the impulse that it can give in this step
     */
    Drag(Sliding body, double most) {
        this.body = body;
        this.most = most;
    }

    /** Gives as much as is needed for it to stand, if it can. */
    void settle() {
        double wantedX = x - body.mass() * body.along();
        double wantedY = y - body.mass() * body.across();
        double size = Math.sqrt(wantedX * wantedX + wantedY * wantedY);
        double share = size > most ? most / size : 1;
        body.push(share * wantedX - x, 1, 0);
        body.push(share * wantedY - y, 0, 1);
        x = share * wantedX;
        y = share * wantedY;
    }
}
