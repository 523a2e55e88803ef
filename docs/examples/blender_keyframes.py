# Turns the selected object of Blender as the body turns:
#   poinsot sample generic --times 0:10/241 -o motion.json
# then run this in Blender's text editor. 24 frames are a second of the motion.
import json
import bpy

clip = json.load(open(bpy.path.abspath("//motion.json")))
track = clip["tracks"][0]
body = bpy.context.object
body.rotation_mode = "QUATERNION"
for i, time_s in enumerate(track["times"]):
    x, y, z, w = track["values"][4 * i : 4 * i + 4]
    body.rotation_quaternion = (w, x, y, z)
    body.keyframe_insert("rotation_quaternion", frame=1 + 24 * time_s)
