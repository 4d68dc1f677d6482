package arcomat.sim.radio;

/**
 * One end of a connection.
 *
 * @param partner the name of the brick at the other end
 * @param outgoing packets from here
 * @param incoming packets from there
 */
public record Link(String partner, Channel outgoing, Channel incoming) {
    public void close() {
        outgoing.close();
        incoming.close();
    }
}
