import lejos.nxt.ColorSensor;
import lejos.nxt.LCD;
import lejos.nxt.SensorPort;
import lejos.nxt.TemperatureSensor;
import lejos.nxt.addon.CompassHTSensor;
import lejos.robotics.Color;
import lejos.util.Delay;

/** Temperature, direction, and a colour by the light of each lamp. */
public class Senses {
    public static void main(String[] args) {
        TemperatureSensor air = new TemperatureSensor(SensorPort.S1);
        CompassHTSensor compass = new CompassHTSensor(SensorPort.S2);
        ColorSensor floor = new ColorSensor(SensorPort.S3);
        air.setResolution(TemperatureSensor.RESOLUTION_12BIT);
        LCD.drawString(compass.getVendorID() + " " + air.getResolution(), 0, 0);
        for (int row = 1; row < 4; row++) {
            String text = (int) air.getTemperature() + " " + (int) compass.getDegrees();
            LCD.drawString(text + " " + (int) compass.getDegreesCartesian(), 0, row);
            compass.resetCartesianZero();
            floor.setFloodlight(Color.RED);
            floor.getLightValue();
            floor.setFloodlight(Color.GREEN);
            floor.getLightValue();
            floor.setFloodlight(Color.WHITE);
            floor.getLightValue();
            floor.getRawColor();
            ColorSensor.Color seen = floor.getColor();
            LCD.drawString(seen.getRed() + " " + seen.getColor(), 0, row + 4);
            Delay.msDelay(100);
        }
    }
}
