# Many runs of the world: how often do the robots collide, whatever the noise, wherever they start?
# Try: a 'require' line that does not hold, and --out build/runs, which keeps every run.
world ${name}.world

vary apart from 1200 to 2400   # mm
vary sonar from 0 to 2         # mm, of a reading of the ultrasonic sensor

sample latin 20

require failure below 0.5 at 90
