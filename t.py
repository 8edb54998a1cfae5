import time
t=time.time()
from clubface import fem
from clubface.fem.settings import Settings
print(time.time()-t)
t=time.time(); a=fem.reference(settings=Settings(threads=1)); print("ref1",time.time()-t, a.steps, a.wall, a.backspin.hex())
t=time.time(); a=fem.reference(); print("refN",time.time()-t, a.steps, a.wall, a.backspin.hex())
import sys; sys.path.insert(0,"studio/tests/browser")
import elements
t=time.time(); d,a=elements.drive("modern",elements.DRIVE,1); print("drive",time.time()-t,a.steps,a.wall, a.backspin.hex())
